#include "studies/shard.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdlib>

#include "contact/base/error.h"

namespace tricontact::studies {

bool Shard::has(const std::string& key) const {
    const std::uint64_t front = std::strtoull(key.substr(0, 16).c_str(), nullptr, 16);
    return front % static_cast<std::uint64_t>(n) == static_cast<std::uint64_t>(i - 1);
}

Shard shard_of(const std::string& text) {
    constexpr int most = 100'000;
    Shard shard;
    if (text.empty()) return shard;
    const char* const end = text.data() + text.size();
    const auto i = std::from_chars(text.data(), end, shard.i);
    const bool slash = i.ec == std::errc() && i.ptr != end && *i.ptr == '/';
    const auto n = std::from_chars(slash ? i.ptr + 1 : end, end, shard.n);
    if (!slash || n.ec != std::errc() || n.ptr != end || shard.i < 1 || shard.n < shard.i ||
        shard.n > most)
        throw contact::InputError(fmt::format(
            "--shard {}: must be i/n with 1 <= i <= n <= {}; write for example --shard 1/8", text,
            most));
    return shard;
}

}  // namespace tricontact::studies
