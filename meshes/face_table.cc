#include "meshes/face_table.h"

#include <algorithm>

#include "meshes/hex_geometry.h"

namespace tricontact::meshes {

namespace {

// Four values: a network of comparisons is faster than a general sort.
std::array<int, 4> sorted(std::array<int, 4> v) {
    auto order = [&](int i, int j) {
        if (v[j] < v[i]) std::swap(v[i], v[j]);
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    return v;
}

}  // namespace

FaceTable::FaceTable(const HexMesh& mesh) {
    sides_.reserve(6 * mesh.hexes.size());
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        for (int f = 0; f < 6; ++f) {
            std::array<int, 4> nodes{};
            for (int i = 0; i < 4; ++i) nodes[i] = mesh.hexes[e][hex_faces[f][i]];
            sides_.push_back({sorted(nodes), static_cast<int>(e), f});
        }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
        return a.key != b.key ? a.key < b.key : a.hex < b.hex;
    });
    for (std::size_t i = 0; i < sides_.size(); ++i)
        if (i == 0 || sides_[i].key != sides_[i - 1].key) begin_.push_back(i);
    begin_.push_back(sides_.size());
}

std::span<const FaceTable::Side> FaceTable::sides(std::size_t face) const {
    return std::span(sides_).subspan(begin_[face], begin_[face + 1] - begin_[face]);
}

std::size_t FaceTable::find(std::array<int, 4> nodes) const {
    const std::array<int, 4> key = sorted(nodes);
    const auto groups = std::span(begin_).first(n_faces());
    const auto at = std::lower_bound(
        groups.begin(), groups.end(), key,
        [&](std::size_t begin, const std::array<int, 4>& k) { return sides_[begin].key < k; });
    if (at == groups.end() || sides_[*at].key != key) return n_faces();
    return static_cast<std::size_t>(at - groups.begin());
}

}  // namespace tricontact::meshes
