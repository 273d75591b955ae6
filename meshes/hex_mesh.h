#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
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

/// Of Boundary or Region: how many names there are.
template <class What>
constexpr int n_names = std::is_same_v<What, Region> ? n_regions : n_boundaries;

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

    bool has_symmetry() const {
        return std::any_of(faces.begin(), faces.end(),
                           [](const Face& face) { return face.boundary == Boundary::symmetry; });
    }
};

using Point = std::array<double, 3>;

Point difference(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
double dot(const Point& a, const Point& b);
double distance(const Point& a, const Point& b);

/// Local corners of the six faces, counter-clockwise from outside: bottom, top, then around.
constexpr std::array<std::array<int, 4>, 6> hex_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Per corner the three that share an edge with it, right-handed in a valid element.
constexpr std::array<std::array<int, 3>, 8> hex_neighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

/// Lengths of the shortest and the longest edge of a hexahedron.
struct EdgeLengths {
    double shortest, longest;
};
EdgeLengths edge_lengths(const std::array<Point, 8>& corners);

/// Corners of a hexahedron [m].
std::array<Point, 8> corners_of(const HexMesh& mesh, const std::array<int, 8>& hex);

/// Least Jacobian determinant [m^3] of the map from the unit cube, over corners, mid-edges,
/// mid-faces and centre. The determinant is quadratic in each coordinate, so these 27 values
/// determine it. NaN if a corner is.
double least_jacobian(const std::array<Point, 8>& corners);

/// Mean of the nodes of a hexahedron or face [m].
template <std::size_t n>
Point centre_of(const HexMesh& mesh, const std::array<int, n>& nodes) {
    Point sum{};
    for (const int node : nodes)
        for (int d = 0; d < 3; ++d) sum[d] += mesh.nodes[node][d] / n;
    return sum;
}

/// Whether the point lies on the quadrilateral or within `tolerance` [m] of it.
bool covers(const std::array<Point, 4>& quadrilateral, const Point& point, double tolerance);

/// How good a mesh is.
struct MeshQuality {
    std::size_t n_nodes = 0, n_hexes = 0, n_contact_faces = 0;
    double least_jacobian = 0;  ///< least corner Jacobian over that of a box of the same edges [-]
    double largest_aspect_ratio = 0;      ///< longest edge over shortest, worst element [-]
    double contact_size = 0;              ///< longest edge of a contact face [m]
    std::array<double, 3> low{}, high{};  ///< corners of the bounding box [m]
};
MeshQuality quality(const HexMesh& mesh);

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
    std::span<const Side> sides(std::size_t face) const {
        return std::span(sides_).subspan(begin_[face], begin_[face + 1] - begin_[face]);
    }
    /// Number of the face with these nodes; n_faces() if no hexahedron has it.
    std::size_t find(std::array<int, 4> nodes) const;

  private:
    std::vector<Side> sides_;         // ascending by key
    std::vector<std::size_t> begin_;  // of each group, and the end
};

}  // namespace tricontact::meshes
