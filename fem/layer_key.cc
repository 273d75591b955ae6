// What a condensed layer depends on, as the name of its file.

#include <xxhash.h>

#include <array>
#include <cstdio>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include "fem/layer_cache.h"
#include "fem/layer_file.h"

namespace tricontact::fem {

namespace {

class Digest {
  public:
    Digest() : state_(XXH3_createState(), &XXH3_freeState) {
        if (!state_) throw std::bad_alloc();
        XXH3_128bits_reset(state_.get());
    }
    template <typename T>
    Digest& operator<<(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double> ||
                          std::is_same_v<T, std::array<double, 3>>,
                      "padding has no meaning");
        XXH3_128bits_update(state_.get(), &value, sizeof(T));
        return *this;
    }
    // With its length: two lists one after another are not the same as one.
    template <typename T>
    Digest& operator<<(const std::vector<T>& values) {
        *this << static_cast<std::uint64_t>(values.size());
        for (const T& value : values) *this << value;
        return *this;
    }
    std::string text() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        std::array<char, layer_key_length + 1> digits{};
        std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                      static_cast<unsigned long long>(hash.high64),
                      static_cast<unsigned long long>(hash.low64));
        return digits.data();
    }

  private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

}  // namespace

std::string LayerCache::key(const LayerProblem& problem) {
    Digest digest;
    for (const char character : std::string(CONDENSING_SOURCES)) digest << character;
    digest << layer_file_version << problem.mesh.nodes << problem.mesh.hexes
           << problem.mesh.regions;
    digest << static_cast<std::uint64_t>(problem.mesh.faces.size());
    for (const auto& face : problem.mesh.faces) digest << face.nodes << face.boundary;
    for (const auto& material : problem.materials) digest << material.young << material.poisson;
    digest << static_cast<int>(problem.base) << static_cast<int>(problem.sides)
           << problem.largest_bulk_ratio;
    return digest.text();
}

}  // namespace tricontact::fem
