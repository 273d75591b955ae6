#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "meshes/hex_mesh.h"
#include "meshes/mesh_checks.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

/// Smallest and largest coordinates of the contact's nodes, and its shortest edge [m].
struct ContactExtent {
    Point low{contact::infinity, contact::infinity, contact::infinity},
        high{-contact::infinity, -contact::infinity, -contact::infinity};
    double size = contact::infinity;
};

ContactExtent contact_extent(const HexMesh& mesh) {
    ContactExtent extent;
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        for (int i = 0; i < 4; ++i) {
            const Point& node = mesh.nodes[face.nodes[i]];
            extent.size =
                std::min(extent.size, distance(node, mesh.nodes[face.nodes[(i + 1) % 4]]));
            for (int d = 0; d < 3; ++d) {
                extent.low[d] = std::min(extent.low[d], node[d]);
                extent.high[d] = std::max(extent.high[d], node[d]);
            }
        }
    }
    return extent;
}

void check_in_plane(const HexMesh& mesh, const HexMesh::Face& face, int d, double value,
                    double tolerance, const std::string& name, const char* remedy) {
    for (const int node : face.nodes)
        if (std::abs(mesh.nodes[node][d] - value) > tolerance)
            fail(name,
                 fmt::format("the {} face at {} does not lie in the plane {} = {:.6g} m",
                             name_of(face.boundary), place(centre_of(mesh, face.nodes)), "xyz"[d],
                             value),
                 remedy);
}

// Faces of this name lie in the plane where coordinate d is `value`.
void check_plane(const HexMesh& mesh, Boundary boundary, int d, double value, double tolerance,
                 const std::string& name, const char* remedy) {
    for (const HexMesh::Face& face : mesh.faces)
        if (face.boundary == boundary)
            check_in_plane(mesh, face, d, value, tolerance, name, remedy);
}

// In y = 0; a slice, whose surface is contact from face to face, has another one.
void check_symmetry(const HexMesh& mesh, const ContactExtent& extent, double tolerance,
                    const std::string& name) {
    const double far = extent.high[1];
    const bool slice = std::ranges::all_of(
        mesh.nodes, [&](const Point& node) { return node[1] <= far + tolerance; });
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::symmetry) continue;
        const bool is_far = slice && std::abs(centre_of(mesh, face.nodes)[1] - far) <= tolerance;
        check_in_plane(mesh, face, 1, is_far ? far : 0, tolerance, name,
                       "the plane of symmetry is y = 0, with the body at y >= 0");
    }
}

// The surface is above everything, the plane of symmetry beside everything.
void check_sides(const HexMesh& mesh, bool symmetric, double tolerance, const std::string& name) {
    for (const Point& node : mesh.nodes) {
        if (node[2] > tolerance)
            fail(name, fmt::format("the node at {} lies above the surface z = 0", place(node)),
                 "turn the mesh so that z points out of the substrate");
        if (symmetric && node[1] < -tolerance)
            fail(name,
                 fmt::format("the node at {} lies beyond the plane of symmetry y = 0", place(node)),
                 "keep the half at y >= 0 only");
    }
}

void check_origin(const ContactExtent& extent, bool symmetric, double tolerance,
                  const std::string& name) {
    const bool in_x = extent.low[0] < -tolerance && extent.high[0] > tolerance;
    const bool in_y = symmetric ? std::abs(extent.low[1]) <= tolerance
                                : extent.low[1] < -tolerance && extent.high[1] > tolerance;
    if (!in_x || !in_y)
        fail(name,
             fmt::format("the contact, {:.6g} m <= x <= {:.6g} m and {:.6g} m <= y <= {:.6g} m, is "
                         "not about the origin",
                         extent.low[0], extent.high[0], extent.low[1], extent.high[1]),
             "move the mesh so that the load is at the origin; a half model names its plane y = 0 "
             "symmetry");
}

void check_base(const HexMesh& mesh, double tolerance, const std::string& name) {
    const auto base = std::ranges::find(mesh.faces, Boundary::base, &HexMesh::Face::boundary);
    const double depth = mesh.nodes[base->nodes[0]][2];
    check_plane(mesh, Boundary::base, 2, depth, tolerance, name, "make the base horizontal");
    if (!(depth < -tolerance))
        fail(name, "the base lies in the surface", "put it at the bottom of the body");
}

void check_contact_is_on_layer(const HexMesh& mesh, const FaceTable& table,
                               const std::string& name) {
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        const FaceTable::Side& side = table.sides(table.find(face.nodes))[0];
        if (mesh.regions[side.hex] != Region::layer)
            fail(name,
                 fmt::format("the contact face at {} belongs to lower_layer",
                             place(centre_of(mesh, face.nodes))),
                 "name the volume under the contact layer");
    }
}

}  // namespace

void check_placement(const HexMesh& mesh, const FaceTable& table, const std::string& name) {
    const ContactExtent extent = contact_extent(mesh);
    const double tolerance = negligible * extent.size;
    const bool symmetric = mesh.has_symmetry();
    const char* surface_remedy = "the surface is z = 0, with the body below";
    check_plane(mesh, Boundary::contact, 2, 0, tolerance, name, surface_remedy);
    check_plane(mesh, Boundary::free_top, 2, 0, tolerance, name, surface_remedy);
    check_symmetry(mesh, extent, tolerance, name);
    check_sides(mesh, symmetric, tolerance, name);
    check_origin(extent, symmetric, tolerance, name);
    check_base(mesh, tolerance, name);
    check_contact_is_on_layer(mesh, table, name);
}

}  // namespace tricontact::meshes
