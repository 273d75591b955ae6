#include <fmt/format.h>

#include <algorithm>

#include "meshes/hex_geometry.h"
#include "meshes/mesh_checks.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

using Face = HexMesh::Face;

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
         "put it into a physical surface: " + boundary_names());
}

}  // namespace

std::array<int, 4> nodes_of(const HexMesh& mesh, const FaceTable::Side& side) {
    std::array<int, 4> nodes{};
    for (int i = 0; i < 4; ++i) nodes[i] = mesh.hexes[side.hex][hex_faces[side.face][i]];
    return nodes;
}

void check_faces(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    check_overlaps(mesh, table, name);
    const std::vector<const Face*> named = named_faces(mesh, table, name);
    for (std::size_t f = 0; f < table.n_faces(); ++f)
        if (table.sides(f).size() == 1 && named[f] == nullptr) refuse_unnamed(mesh, table, f, name);
}

}  // namespace tricontact::meshes
