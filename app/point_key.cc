#include "app/point_key.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <cstdlib>

namespace tricontact::app {

std::string point_key(const std::string& resolved) {
    const std::string text = std::string(TRICONTACT_VERSION) + '\n' + resolved;
    const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

bool Shard::has(const std::string& key) const {
    const std::uint64_t front = std::strtoull(key.substr(0, 16).c_str(), nullptr, 16);
    return front % static_cast<std::uint64_t>(n) == static_cast<std::uint64_t>(i - 1);
}

}  // namespace tricontact::app
