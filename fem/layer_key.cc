// What a condensed layer depends on, as the name of its file.

#include <array>
#include <type_traits>
#include <vector>

#include "fem/condensing_sources.h"
#include "fem/layer_cache.h"
#include "fem/layer_file.h"
#include "files/digest.h"

namespace tricontact::fem {

namespace {

class KeyDigest {
  public:
    template <typename T>
    KeyDigest& operator<<(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double> ||
                          std::is_same_v<T, std::array<double, 3>>,
                      "padding has no meaning");
        digest_.add(&value, sizeof(T));
        return *this;
    }
    // With its length: two lists one after another are not the same as one.
    template <typename T>
    KeyDigest& operator<<(const std::vector<T>& values) {
        *this << static_cast<std::uint64_t>(values.size());
        for (const T& value : values) *this << value;
        return *this;
    }
    KeyDigest& operator<<(std::string_view text) {
        digest_ << text;
        return *this;
    }
    std::string text() const { return digest_.text(); }

  private:
    files::Digest digest_;
};

}  // namespace

std::string LayerCache::key(const LayerProblem& problem) {
    KeyDigest digest;
    digest << condensing_sources_digest() << layer_file_version << problem.mesh.nodes
           << problem.mesh.hexes << problem.mesh.regions;
    digest << static_cast<std::uint64_t>(problem.mesh.faces.size());
    for (const auto& face : problem.mesh.faces) digest << face.nodes << face.boundary;
    for (const auto& material : problem.materials) digest << material.young << material.poisson;
    digest << static_cast<int>(problem.base) << static_cast<int>(problem.sides)
           << problem.largest_bulk_ratio;
    return digest.text();
}

}  // namespace tricontact::fem
