#include "app/point_key.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace tricontact::app {

namespace {

std::string digest(const std::string& text) {
    const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string point_key(const std::string& resolved) {
    return digest(std::string(TRICONTACT_VERSION) + '\n' + resolved);
}

std::string file_digests(const contact::Case& c) {
    std::string digests;
    for (const auto* name : {&c.indenter.file, &c.bem.influence, &c.fem.mesh}) {
        if (!*name) continue;
        std::ifstream file(**name, std::ios::binary);
        digests += digest({std::istreambuf_iterator<char>(file), {}}) + '\n';
    }
    return digests;
}

bool Shard::has(const std::string& key) const {
    const std::uint64_t front = std::strtoull(key.substr(0, 16).c_str(), nullptr, 16);
    return front % static_cast<std::uint64_t>(n) == static_cast<std::uint64_t>(i - 1);
}

}  // namespace tricontact::app
