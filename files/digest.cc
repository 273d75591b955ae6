#include "files/digest.h"

#include <xxhash.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <new>

namespace tricontact::files {

Digest::Digest() : state_(XXH3_createState(), [](XXH3_state_t* state) { XXH3_freeState(state); }) {
    if (!state_) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
}

Digest& Digest::add(const void* bytes, std::size_t n) {
    XXH3_128bits_update(state_.get(), bytes, n);
    return *this;
}

Digest& Digest::operator<<(std::string_view text) {
    const auto length = static_cast<std::uint64_t>(text.size());
    return add(&length, sizeof length).add(text.data(), text.size());
}

std::string Digest::text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    std::array<char, 33> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                  static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return digits.data();
}

std::string digest_of(std::string_view bytes) {
    return Digest().add(bytes.data(), bytes.size()).text();
}

}  // namespace tricontact::files
