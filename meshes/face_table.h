#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Which hexahedra meet at a face: found by the face's nodes in any order.
class FaceTable {
  public:
    /// One face of one hexahedron.
    struct Side {
        std::array<int, 4> key;  ///< nodes, ascending
        int hex;
        int face;  ///< 0 to 5, into hex_faces
    };

    explicit FaceTable(const HexMesh& mesh);

    /// Groups of equal nodes: one side at the boundary, two inside a sound body.
    std::size_t n_faces() const { return begin_.size() - 1; }
    std::span<const Side> sides(std::size_t face) const;
    /// Number of the face with these nodes; n_faces() if no hexahedron has it.
    std::size_t find(std::array<int, 4> nodes) const;

  private:
    std::vector<Side> sides_;         // ascending by key
    std::vector<std::size_t> begin_;  // of each group, and the end
};

}  // namespace tricontact::meshes
