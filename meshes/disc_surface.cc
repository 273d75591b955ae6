#include "meshes/disc_surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/base/special_values.h"
#include "meshes/layer_grid.h"
#include "meshes/round_body_parts.h"

namespace tricontact::meshes {

namespace {

// Numbers of lines i, j from -n to n.
struct Lines {
    std::array<int, 2> n_patch, n;
    bool half;

    int first_j() const { return half ? 0 : -n[1]; }
    int node(int i, int j) const { return (j - first_j()) * (2 * n[0] + 1) + i + n[0]; }
};

// Nodes of the square's edge, anticlockwise from i = n, the lowest j.
std::vector<int> circle_of(const Lines& lines) {
    const auto [n_x, n_y] = lines.n;
    std::vector<int> circle;
    for (int j = lines.first_j(); j <= n_y; ++j) circle.push_back(lines.node(n_x, j));
    for (int i = n_x - 1; i >= -n_x; --i) circle.push_back(lines.node(i, n_y));
    for (int j = n_y - 1; j >= lines.first_j(); --j) circle.push_back(lines.node(-n_x, j));
    if (lines.half) return circle;
    for (int i = -n_x + 1; i < n_x; ++i) circle.push_back(lines.node(i, -n_y));
    return circle;
}

}  // namespace

DiscSurface::DiscSurface(const DiscSpec& s) {
    Lines lines{{elements_in(s.patch_x, s.size), elements_in(s.patch_y, s.size)}, {}, s.half_model};
    const double side = std::max(s.patch_x, s.patch_y), way_at_side = s.rim - s.way(side);
    const Grading around = grade(way_at_side, s.way(side) - s.way(side - s.size), s.growth);
    const std::vector<double> ring = around.nodes();
    for (int d = 0; d < 2; ++d) lines.n[d] = lines.n_patch[d] + around.n;
    const auto place = [&](int i, int j) -> std::array<double, 2> {
        const int strip =
            std::max({std::abs(i) - lines.n_patch[0], std::abs(j) - lines.n_patch[1], 0});
        // Beyond the patch as on a square around it, in the direction of the node.
        const auto lateral = [&](int index, int n_patch) {
            const int inside = std::min(std::abs(index), n_patch);
            const double beyond = ring[std::abs(index) - inside] / way_at_side * (s.rim - side);
            return (index < 0 ? -1 : 1) * (inside * s.size + beyond);
        };
        const double x = lateral(i, lines.n_patch[0]), y = lateral(j, lines.n_patch[1]);
        if (strip == 0) return {x, y};
        const double r = std::hypot(x, y);
        const double edge = r * std::min(x == 0 ? contact::infinity : s.patch_x / std::abs(x),
                                         y == 0 ? contact::infinity : s.patch_y / std::abs(y));
        const double way = way_beyond_patch(ring[strip] / way_at_side, s.way(edge), s.rim,
                                            way_at_side, r / std::max(std::abs(x), std::abs(y)));
        const double from_axis = s.distance(way);
        return {from_axis * (x / r), from_axis * (y / r)};
    };
    for (int j = lines.first_j(); j <= lines.n[1]; ++j)
        for (int i = -lines.n[0]; i <= lines.n[0]; ++i) nodes_.push_back(place(i, j));
    const auto within = [](int index, int n) { return -n <= index && index < n; };
    for (int j = lines.first_j(); j < lines.n[1]; ++j)
        for (int i = -lines.n[0]; i < lines.n[0]; ++i) {
            quads_.push_back({lines.node(i, j), lines.node(i + 1, j), lines.node(i + 1, j + 1),
                              lines.node(i, j + 1)});
            in_patch_.push_back(within(i, lines.n_patch[0]) && within(j, lines.n_patch[1]));
        }
    circle_ = circle_of(lines);
}

HexMesh in_layers(const std::vector<std::array<int, 4>>& quads, const std::vector<bool>& in_contact,
                  int n_surface, int n_layers, const std::function<Point(int, int)>& place) {
    HexMesh mesh;
    for (int m = 0; m <= n_layers; ++m)
        for (int s = 0; s < n_surface; ++s) mesh.nodes.push_back(place(s, m));
    std::map<std::array<int, 2>, int> uses;
    const auto edge_of = [](int a, int b) { return std::array{std::min(a, b), std::max(a, b)}; };
    for (const auto& quad : quads)
        for (int k = 0; k < 4; ++k) ++uses[edge_of(quad[k], quad[(k + 1) % 4])];
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const auto& quad = quads[q];
        const auto at = [&](int corner, int m) { return m * n_surface + quad[corner % 4]; };
        for (int m = 0; m < n_layers; ++m) {
            mesh.hexes.push_back({at(0, m), at(1, m), at(2, m), at(3, m), at(0, m + 1),
                                  at(1, m + 1), at(2, m + 1), at(3, m + 1)});
            for (int k = 0; k < 4; ++k) {
                if (uses.at(edge_of(quad[k], quad[(k + 1) % 4])) > 1) continue;
                const bool middle =
                    mesh.nodes[at(k, m)][1] == 0 && mesh.nodes[at(k + 1, m)][1] == 0;
                mesh.faces.push_back({{at(k, m), at(k + 1, m), at(k + 1, m + 1), at(k, m + 1)},
                                      middle ? Boundary::symmetry : Boundary::sides});
            }
        }
        mesh.faces.push_back({{at(0, 0), at(3, 0), at(2, 0), at(1, 0)}, Boundary::base});
        mesh.faces.push_back({{at(0, n_layers), at(1, n_layers), at(2, n_layers), at(3, n_layers)},
                              in_contact[q] ? Boundary::contact : Boundary::sides});
    }
    mesh.regions.assign(mesh.hexes.size(), Region::layer);
    return mesh;
}

}  // namespace tricontact::meshes
