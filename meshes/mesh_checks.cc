#include "meshes/mesh_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <cstdint>
#include <map>

#include "contact/base/special_values.h"
#include "meshes/mesh_file.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

void check_numbers(const HexMesh& mesh, const std::string& name) {
    auto exists = [&](int node) {
        return node >= 0 && static_cast<std::size_t>(node) < mesh.nodes.size();
    };
    auto all_exist = [&](const auto& nodes) { return std::ranges::all_of(nodes, exists); };
    if (!std::ranges::all_of(mesh.hexes, all_exist) ||
        !std::ranges::all_of(mesh.faces, all_exist, &HexMesh::Face::nodes))
        fail(name, "an element has a node that does not exist",
             fmt::format("number nodes from 0 to {}", static_cast<long>(mesh.nodes.size()) - 1));
    if (mesh.regions.size() != mesh.hexes.size())
        fail(name,
             fmt::format("{} regions for {} hexahedra", mesh.regions.size(), mesh.hexes.size()),
             "give each hexahedron a region");
}

using Face = HexMesh::Face;

// Counter-clockwise from outside.
std::array<int, 4> nodes_of(const HexMesh& mesh, const FaceTable::Side& side) {
    std::array<int, 4> nodes{};
    for (int i = 0; i < 4; ++i) nodes[i] = mesh.hexes[side.hex][hex_faces[side.face][i]];
    return nodes;
}

std::string describe(const HexMesh& mesh, const Face& face) {
    return fmt::format("the {} face at {}", name_of(face.boundary),
                       place(centre_of(mesh, face.nodes)));
}

void check_overlaps(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() > 2)
            fail(name,
                 fmt::format("{} hexahedra share the face at {}", table.sides(f).size(),
                             place(centre_of(mesh, table.sides(f)[0].key))),
                 "remove elements that lie in others");
}

// Nodes 0 and 2 of a cyclic face lie opposite each other.
bool is_cyclic(const std::array<int, 4>& cycle, const std::array<int, 4>& nodes) {
    const auto first = std::ranges::find(cycle, nodes[0]) - cycle.begin();
    return cycle[(first + 2) % 4] == nodes[2];
}

void check_named_face(const HexMesh& mesh, const FaceTable& table, std::size_t at, const Face& face,
                      const std::string& name) {
    if (at == table.n_faces())
        fail(name, describe(mesh, face) + " is no face of a hexahedron",
             "mesh surface and volume together, so that they share their nodes");
    const auto sides = table.sides(at);
    if (sides.size() > 1)
        fail(name, describe(mesh, face) + " lies inside the body",
             "name boundary faces of the body only");
    if (!is_cyclic(nodes_of(mesh, sides[0]), face.nodes))
        fail(name, describe(mesh, face) + " has its nodes crosswise", "list them around the face");
}

// The name of each face of the table, null if it has none; throws if it has two.
std::vector<const Face*> named_faces(const HexMesh& mesh, const FaceTable& table,
                                     const std::string& name) {
    std::vector<const Face*> named(table.n_faces(), nullptr);
    for (const Face& face : mesh.faces) {
        const std::size_t at = table.find(face.nodes);
        check_named_face(mesh, table, at, face, name);
        if (named[at] != nullptr)
            fail(name,
                 fmt::format("{} is named twice: {} and {}", describe(mesh, face),
                             name_of(named[at]->boundary), name_of(face.boundary)),
                 "put it into one physical surface only, once");
        named[at] = &face;
    }
    return named;
}

// Whether another boundary face covers this point: blocks that touch, divided differently.
bool touches_another(const HexMesh& mesh, const FaceTable& table, std::size_t face,
                     const Point& centre, double tolerance) {
    for (std::size_t f = 0; f < table.n_faces(); ++f) {
        if (f == face || table.sides(f).size() != 1) continue;
        std::array<Point, 4> corners;
        std::ranges::transform(nodes_of(mesh, table.sides(f)[0]), corners.begin(),
                               [&](int node) { return mesh.nodes[node]; });
        if (covers(corners, centre, tolerance)) return true;
    }
    return false;
}

[[noreturn]] void refuse_unnamed(const HexMesh& mesh, const FaceTable& table, std::size_t face,
                                 const std::string& name) {
    const std::array<int, 4> nodes = nodes_of(mesh, table.sides(face)[0]);
    const Point centre = centre_of(mesh, nodes);
    const double diagonal = distance(mesh.nodes[nodes[0]], mesh.nodes[nodes[2]]);
    if (touches_another(mesh, table, face, centre, negligible * diagonal))
        fail(name,
             fmt::format("the face at {} touches another without sharing its nodes (hanging nodes)",
                         place(centre)),
             "divide the blocks on both sides alike");
    fail(name, fmt::format("the boundary face at {} has no name", place(centre)),
         "put it into a physical surface: " + all_names<Boundary>());
}

std::vector<int> boundary_nodes(const HexMesh& mesh, const FaceTable& table) {
    std::vector<char> is_boundary(mesh.nodes.size(), 0);
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 1)
            for (const int node : table.sides(f)[0].key) is_boundary[node] = 1;
    std::vector<int> nodes;
    for (std::size_t i = 0; i < is_boundary.size(); ++i)
        if (is_boundary[i] != 0) nodes.push_back(static_cast<int>(i));
    return nodes;
}

double shortest_edge(const HexMesh& mesh) {
    double shortest = contact::infinity;
    for (const auto& hex : mesh.hexes)
        shortest = std::min(shortest, edge_lengths(corners_of(mesh, hex)).shortest);
    return shortest;
}

using Cell = std::array<std::int64_t, 3>;

// Finds an earlier node within `tolerance` of each new one, in cells much larger than that.
class NodeHash {
  public:
    NodeHash(const HexMesh& mesh, double cell, double tolerance)
        : mesh_(mesh), cell_(cell), tolerance_(tolerance) {}

    /// The node at the same place, or -1.
    int add(int node) {
        const Point& p = mesh_.nodes[node];
        const Cell low = cell_of(p, -tolerance_), high = cell_of(p, tolerance_);
        for (std::int64_t i = low[0]; i <= high[0]; ++i)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t k = low[2]; k <= high[2]; ++k) {
                    const auto [begin, end] = nodes_.equal_range({i, j, k});
                    for (auto at = begin; at != end; ++at)
                        if (distance(mesh_.nodes[at->second], p) <= tolerance_) return at->second;
                }
        nodes_.emplace(cell_of(p, 0), node);
        return -1;
    }

  private:
    Cell cell_of(const Point& p, double shift) const {
        Cell cell{};
        for (int d = 0; d < 3; ++d)
            cell[d] = static_cast<std::int64_t>(
                std::clamp(std::floor((p[d] + shift) / cell_), -farthest, farthest));
        return cell;
    }

    // A whole number of 64 bits; bodies so far from the origin are refused by their place.
    static constexpr double farthest = 0x1p62;

    const HexMesh& mesh_;
    double cell_, tolerance_;
    std::multimap<Cell, int> nodes_;
};

// Node numbers exist, hexahedra are neither inverted nor flat.
void check_elements(const HexMesh& mesh, const std::string& name) {
    check_numbers(mesh, name);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e) {
        const std::array<Point, 8> corners = corners_of(mesh, mesh.hexes[e]);
        const double edge = edge_lengths(corners).longest, jacobian = least_jacobian(corners);
        // Rounding makes flat elements positive by some 1e-16 of the edge's cube; false for NaN.
        if (!(jacobian > 1e-12 * edge * edge * edge))
            fail(name,
                 fmt::format("hexahedron {} of {}, centre {}, is inverted or flat: its Jacobian "
                             "falls to {:.3g} m^3",
                             e + 1, mesh.hexes.size(), place(centre_of(mesh, mesh.hexes[e])),
                             jacobian),
                 "list its nodes bottom first, then top, both counter-clockwise from above, and "
                 "check their positions");
    }
}

// There is a contact, a base and a layer.
void check_names(const HexMesh& mesh, const std::string& name) {
    auto require = [&](bool found, const char* kind, const char* what) {
        if (!found)
            fail(name, fmt::format("has no {} \"{}\"", kind, what),
                 fmt::format("make a physical {} of this name", kind));
    };
    require(std::ranges::count(mesh.regions, Region::layer) > 0, "volume", name_of(Region::layer));
    for (const Boundary boundary : {Boundary::contact, Boundary::base})
        require(std::ranges::count(mesh.faces, boundary, &HexMesh::Face::boundary) > 0, "surface",
                name_of(boundary));
}

// At most two hexahedra at a face; every boundary face named, once; no other face named.
void check_faces(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    check_overlaps(mesh, table, name);
    const std::vector<const Face*> named = named_faces(mesh, table, name);
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 1 && named[f] == nullptr) refuse_unnamed(mesh, table, f, name);
}

// No two boundary nodes at one place: blocks that touch share their nodes.
void check_coincident_nodes(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    const double edge = shortest_edge(mesh);
    // Nodes of an element are at least an edge apart; a thousandth allows for sloppy positions.
    NodeHash hash(mesh, edge / 2, edge / 1000);
    for (const int node : boundary_nodes(mesh, table)) {
        const int other = hash.add(node);
        if (other >= 0)
            fail(name,
                 fmt::format("two nodes lie at {}: the elements there are not connected",
                             place(mesh.nodes[node])),
                 "let neighbouring blocks share points, curves and surfaces (gmsh: Coherence)");
    }
}

// The body is in one piece.
void check_connected(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    boost::disjoint_sets_with_storage<> parts(mesh.hexes.size());
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 2)
            parts.union_set(table.sides(f)[0].hex, table.sides(f)[1].hex);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        if (parts.find_set(e) != parts.find_set(std::size_t{0}))
            fail(name,
                 fmt::format("the body is in pieces: {} and {} are not connected",
                             place(centre_of(mesh, mesh.hexes[0])),
                             place(centre_of(mesh, mesh.hexes[e]))),
                 "remove one piece, or join them by shared faces");
}

}  // namespace

void check_shape(const HexMesh& mesh, const std::string& name) {
    check_elements(mesh, name);
}

void check_solid(const HexMesh& mesh, const std::string& name) {
    const FaceTable table(mesh);
    check_coincident_nodes(mesh, table, name);
    check_faces(mesh, table, name);
    check_connected(mesh, table, name);
}

// In the order in which the parts rely on each other.
void verify(const HexMesh& mesh, const std::string& name) {
    check_elements(mesh, name);
    check_names(mesh, name);
    const FaceTable table(mesh);
    check_coincident_nodes(mesh, table, name);
    check_faces(mesh, table, name);
    check_connected(mesh, table, name);
    check_placement(mesh, table, name);
}

}  // namespace tricontact::meshes
