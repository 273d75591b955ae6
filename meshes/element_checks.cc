#include <fmt/format.h>

#include <algorithm>

#include "meshes/hex_geometry.h"
#include "meshes/mesh_checks.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

double longest_edge(const std::array<Point, 8>& corners) {
    double longest = 0;
    for (const auto& [from, to] : hex_edges)
        longest = std::max(longest, distance(corners[from], corners[to]));
    return longest;
}

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

}  // namespace

void check_elements(const HexMesh& mesh, const std::string& name) {
    check_numbers(mesh, name);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e) {
        const std::array<Point, 8> corners = corners_of(mesh, mesh.hexes[e]);
        const double edge = longest_edge(corners), jacobian = least_jacobian(corners);
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

}  // namespace tricontact::meshes
