#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tricontact::meshes {

/// What a boundary face is for; names of the physical surfaces in a mesh file.
enum class Boundary : std::uint8_t { contact, free_top, base, sides, symmetry };
constexpr int n_boundaries = 5;
/// "contact", "free_top", "base", "sides", "symmetry".
const char* name_of(Boundary boundary);

/// What a hexahedron is made of; names of the physical volumes in a mesh file.
enum class Region : std::uint8_t { layer, lower_layer };
constexpr int n_regions = 2;
/// "layer", "lower_layer".
const char* name_of(Region region);

/// Straight-sided hexahedra. z points out of the substrate: its surface is z = 0, the body below;
/// the contact is about the origin, the load along x, a symmetry plane is y = 0 with the body at
/// y >= 0.
struct HexMesh {
    struct Face {
        std::array<int, 4> nodes;  ///< cyclic
        Boundary boundary;
    };
    std::vector<std::array<double, 3>> nodes;  ///< [m]
    std::vector<std::array<int, 8>> hexes;     ///< nodes in the order of gmsh and VTK
    std::vector<Region> regions;               ///< per hexahedron
    std::vector<Face> faces;                   ///< every boundary face, once

    bool has_symmetry() const;
};

}  // namespace tricontact::meshes
