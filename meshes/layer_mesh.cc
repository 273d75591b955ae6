#include "meshes/layer_mesh.h"

#include <algorithm>
#include <utility>

#include "meshes/layer_grid.h"

namespace tricontact::meshes {

namespace {

// Strip of each element of an axis.
std::vector<int> strips_of(const GridAxis& axis) {
    std::vector<int> strips;
    for (int s = 0; s < axis.n_strips(); ++s) strips.insert(strips.end(), axis.strips[s].n, s);
    return strips;
}

// Name of the face across axis d of an element in these strips.
Boundary boundary_of(const LayerGrid& grid, int d, bool high, int strip_x, int strip_y) {
    if (d == 1 && (high ? grid.symmetric_high : grid.symmetric_low)) return Boundary::symmetry;
    if (d < 2) return Boundary::sides;
    if (!high) return Boundary::base;
    const bool in_patch =
        strip_x == grid.patch_x && strip_y >= grid.patch_y && strip_y <= grid.last_patch_y;
    return in_patch ? Boundary::contact : Boundary::free_top;
}

}  // namespace

HexMesh make_layer_mesh(const LayerMeshSpec& spec) {
    const LayerGrid grid = layer_grid(spec);
    const auto& [x, y, z] = grid.axes;
    const std::array n{x.n_elements(), y.n_elements(), z.n_elements()};
    const std::array stride{1, n[0] + 1, (n[0] + 1) * (n[1] + 1)};
    const std::array strips{strips_of(x), strips_of(y), strips_of(z)};
    HexMesh mesh;
    for (const double height : z.nodes)
        for (const double across : y.nodes)
            for (const double along : x.nodes) mesh.nodes.push_back({along, across, height});
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i) {
                const std::array at{i, j, k};
                const int up = stride[2], c = i + stride[1] * j + up * k, b = c + stride[1];
                mesh.hexes.push_back({c, c + 1, b + 1, b, c + up, c + 1 + up, b + 1 + up, b + up});
                mesh.regions.push_back(strips[2][k] == grid.layer ? Region::layer
                                                                  : Region::lower_layer);
                for (int d = 0; d < 3; ++d) {  // faces, counter-clockwise from outside
                    const int e = stride[(d + 1) % 3], f = stride[(d + 2) % 3], h = c + stride[d];
                    const auto name = [&](bool high) {
                        return boundary_of(grid, d, high, strips[0][i], strips[1][j]);
                    };
                    if (at[d] == 0)
                        mesh.faces.push_back({{c, c + f, c + e + f, c + e}, name(false)});
                    if (at[d] + 1 == n[d])
                        mesh.faces.push_back({{h, h + e, h + e + f, h + f}, name(true)});
                }
            }
    std::ranges::sort(mesh.faces, {}, [](const HexMesh::Face& face) {
        auto nodes = face.nodes;
        std::ranges::sort(nodes);
        return std::pair(face.boundary, nodes);
    });
    return mesh;
}

}  // namespace tricontact::meshes
