#include "fem/distributed/mesh_part.h"

#include <vector>

#include "meshes/face_table.h"
#include "meshes/hex_geometry.h"

namespace tricontact::fem::distributed {

namespace {

using meshes::Boundary;
using meshes::HexMesh;

// Hexahedra and nodes; returns the new number of each old node, -1: not in the part.
std::vector<int> take_hexes(const HexMesh& mesh, std::span<const int> hexes, HexMesh& part) {
    std::vector<int> number(mesh.nodes.size(), -1);
    for (const int h : hexes) {
        auto& nodes = part.hexes.emplace_back(mesh.hexes[h]);
        part.regions.push_back(mesh.regions[h]);
        for (int& node : nodes) {
            if (number[node] < 0) {
                number[node] = static_cast<int>(part.nodes.size());
                part.nodes.push_back(mesh.nodes[node]);
            }
            node = number[node];
        }
    }
    return number;
}

}  // namespace

HexMesh part_of(const HexMesh& mesh, std::span<const int> hexes) {
    HexMesh part;
    const std::vector<int> number = take_hexes(mesh, hexes, part);
    const meshes::FaceTable table(part);
    std::vector<Boundary> names(table.n_faces(), Boundary::free_top);
    for (const auto& face : mesh.faces) {
        std::array<int, 4> nodes{};
        for (int i = 0; i < 4; ++i) nodes[i] = number[face.nodes[i]];
        const std::size_t at = table.find(nodes);
        if (at < table.n_faces()) names[at] = face.boundary;
    }
    for (std::size_t f = 0; f < table.n_faces(); ++f) {
        if (table.sides(f).size() != 1) continue;
        const auto& side = table.sides(f)[0];
        auto& face = part.faces.emplace_back(HexMesh::Face{{}, names[f]});
        for (int i = 0; i < 4; ++i)
            face.nodes[i] = part.hexes[side.hex][meshes::hex_faces[side.face][i]];
    }
    return part;
}

}  // namespace tricontact::fem::distributed
