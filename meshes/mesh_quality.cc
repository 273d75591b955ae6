#include "meshes/mesh_quality.h"

#include <algorithm>
#include <limits>

#include "meshes/hex_geometry.h"

namespace tricontact::meshes {

namespace {

// Knupp (2000): Jacobian matrix norm and scaled Jacobian at the corners.
double scaled_jacobian(const std::array<Point, 8>& corners) {
    double least = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 8; ++c) {
        std::array<Point, 3> edges;
        double box = 1;
        for (int i = 0; i < 3; ++i) {
            const Point& end = corners[hex_neighbours[c][i]];
            edges[i] = difference(end, corners[c]);
            box *= distance(end, corners[c]);
        }
        least = std::min(least, dot(cross(edges[0], edges[1]), edges[2]) / box);
    }
    return least;
}

double aspect_ratio(const std::array<Point, 8>& corners) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (const auto& [from, to] : hex_edges) {
        const double edge = distance(corners[from], corners[to]);
        shortest = std::min(shortest, edge);
        longest = std::max(longest, edge);
    }
    return longest / shortest;
}

void measure_contact(const HexMesh& mesh, MeshQuality& quality) {
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        ++quality.n_contact_faces;
        for (int i = 0; i < 4; ++i)
            quality.contact_size =
                std::max(quality.contact_size,
                         distance(mesh.nodes[face.nodes[i]], mesh.nodes[face.nodes[(i + 1) % 4]]));
    }
}

void measure_box(const HexMesh& mesh, MeshQuality& quality) {
    if (mesh.nodes.empty()) return;
    quality.low = quality.high = mesh.nodes.front();
    for (const auto& node : mesh.nodes)
        for (int d = 0; d < 3; ++d) {
            quality.low[d] = std::min(quality.low[d], node[d]);
            quality.high[d] = std::max(quality.high[d], node[d]);
        }
}

}  // namespace

MeshQuality quality(const HexMesh& mesh) {
    MeshQuality quality;
    quality.n_nodes = mesh.nodes.size();
    quality.n_hexes = mesh.hexes.size();
    if (!mesh.hexes.empty()) quality.least_jacobian = std::numeric_limits<double>::infinity();
    for (const auto& hex : mesh.hexes) {
        const std::array<Point, 8> corners = corners_of(mesh, hex);
        quality.least_jacobian = std::min(quality.least_jacobian, scaled_jacobian(corners));
        quality.largest_aspect_ratio =
            std::max(quality.largest_aspect_ratio, aspect_ratio(corners));
    }
    measure_contact(mesh, quality);
    measure_box(mesh, quality);
    return quality;
}

}  // namespace tricontact::meshes
