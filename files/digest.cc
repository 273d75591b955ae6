#include "files/digest.h"

#include <xxhash.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <new>

namespace tricontact::files {

struct Digest::State {
    State() : hash(XXH3_createState(), &XXH3_freeState) {
        if (!hash) throw std::bad_alloc();
        XXH3_128bits_reset(hash.get());
    }
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> hash;
};

Digest::Digest() : state_(std::make_unique<State>()) {}
Digest::~Digest() = default;

Digest& Digest::add(const void* bytes, std::size_t n) {
    XXH3_128bits_update(state_->hash.get(), bytes, n);
    return *this;
}

Digest& Digest::operator<<(std::string_view text) {
    const auto length = static_cast<std::uint64_t>(text.size());
    return add(&length, sizeof length).add(text.data(), text.size());
}

std::string Digest::text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_->hash.get());
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
