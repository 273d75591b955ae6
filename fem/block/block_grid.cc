#include "fem/block/block_grid.h"

#include <algorithm>
#include <cmath>

#include "fem/discretisation.h"

namespace tricontact::fem {

namespace {

using meshes::HexMesh;

/// Coordinates along an axis, ascending, those within rounding of each other once.
std::vector<double> planes_of(const HexMesh& mesh, int axis) {
    std::vector<double> all;
    all.reserve(mesh.nodes.size());
    for (const auto& x : mesh.nodes) all.push_back(x[axis]);
    std::ranges::sort(all);
    const double rounding = 1e-9 * (all.back() - all.front());
    std::vector<double> planes{all.front()};
    for (const double x : all)
        if (x - planes.back() > rounding) planes.push_back(x);
    return planes;
}

int plane_at(const std::vector<double>& planes, double x) {
    const auto above = std::ranges::lower_bound(planes, x);
    if (above == planes.end()) return static_cast<int>(planes.size()) - 1;
    const auto k = static_cast<int>(above - planes.begin());
    return k > 0 && x - planes[k - 1] < planes[k] - x ? k - 1 : k;
}

using Cell = std::array<int, 3>;

/// Empty unless the corners lie on two neighbouring planes of each axis.
std::optional<Cell> cell_of(const BlockGrid& grid, const HexMesh& mesh,
                            const std::array<int, 8>& hex) {
    Cell low{};
    for (int d = 0; d < 3; ++d) {
        int first = grid.axes[d].n_elements(), last = 0;
        for (const int node : hex) {
            const int plane = plane_at(grid.axes[d].planes, mesh.nodes[node][d]);
            first = std::min(first, plane);
            last = std::max(last, plane);
        }
        if (last != first + 1) return std::nullopt;
        low[d] = first;
    }
    return low;
}

/// Regions by layers of elements; false if one has both.
bool take_moduli(const LayerProblem& problem, BlockGrid& grid) {
    std::vector<int> region(grid.axes[2].n_elements(), -1);
    const HexMesh& mesh = problem.mesh;
    for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
        const auto cell = cell_of(grid, mesh, mesh.hexes[h]);
        if (!cell) return false;
        const int own = static_cast<int>(mesh.regions[h]);
        int& of_layer = region[(*cell)[2]];
        if (of_layer >= 0 && of_layer != own) return false;
        of_layer = own;
    }
    for (const int r : region)
        grid.moduli.push_back(moduli_of(problem.materials[r], problem.largest_bulk_ratio));
    return true;
}

/// What holds each side of the block; false if a side is held in two ways, or a face lies inside.
bool take_sides(const LayerProblem& problem, BlockGrid& grid) {
    std::array<std::array<int, 2>, 3> held{{{-1, -1}, {-1, -1}, {-1, -1}}};
    for (const auto& face : problem.mesh.faces) {
        int axis = -1, end = -1;
        for (int d = 0; d < 3; ++d)
            for (int e = 0; e < 2; ++e) {
                const int wanted = e == 0 ? 0 : grid.axes[d].n_elements();
                if (std::ranges::all_of(face.nodes, [&](int node) {
                        return plane_at(grid.axes[d].planes, problem.mesh.nodes[node][d]) == wanted;
                    })) {
                    axis = d;
                    end = e;
                }
            }
        if (axis < 0) return false;
        int& of_side = held[axis][end];
        const int own = held_on(face.boundary, problem.base, problem.sides);
        if (of_side >= 0 && of_side != own) return false;
        of_side = own;
    }
    for (int d = 0; d < 3; ++d)
        for (int e = 0; e < 2; ++e)
            grid.axes[d].held[e] = static_cast<std::uint8_t>(std::max(0, held[d][e]));
    return true;
}

/// Number of the node nearest to x along an axis.
int node_along(const BlockAxis& axis, double x) {
    int low = 0, high = axis.n_nodes() - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (axis.node(middle) <= x ? low : high) = middle;
    }
    return x - axis.node(low) < axis.node(high) - x ? low : high;
}

}  // namespace

std::size_t BlockGrid::nearest_node(const std::array<double, 3>& x) const {
    return node(node_along(axes[0], x[0]), node_along(axes[1], x[1]), node_along(axes[2], x[2]));
}

std::optional<BlockGrid> block_grid(const LayerProblem& problem, std::string& why) {
    const HexMesh& mesh = problem.mesh;
    BlockGrid grid;
    for (int d = 0; d < 3; ++d) grid.axes[d].planes = planes_of(mesh, d);
    const auto& [x, y, z] = grid.axes;
    if (mesh.nodes.size() != x.planes.size() * y.planes.size() * z.planes.size() ||
        mesh.hexes.size() != grid.n_elements() || !take_moduli(problem, grid)) {
        why =
            "its elements are not bricks between planes x, y, z = const, in layers of one "
            "material each";
        return std::nullopt;
    }
    if (!take_sides(problem, grid)) {
        why = "one of its sides is held in two ways";
        return std::nullopt;
    }
    const auto has = [&](meshes::Boundary boundary) {
        return std::ranges::any_of(mesh.faces,
                                   [&](const auto& face) { return face.boundary == boundary; });
    };
    refuse_rigid_motions(has(meshes::Boundary::base), has(meshes::Boundary::sides), problem.base,
                         problem.sides);
    grid.mirrored = mesh.has_symmetry();
    return grid;
}

std::vector<std::size_t> places_in_block(const Discretisation& body, const BlockGrid& grid) {
    const Unknowns& unknowns = body.unknowns;
    std::vector<std::size_t> places;
    places.reserve(unknowns.n);
    for (int u = 0; u < unknowns.n; ++u)
        places.push_back(unknowns.direction_of_unknown[u] * grid.n_nodes() +
                         grid.nearest_node(body.space.nodes[unknowns.node_of_unknown[u]]));
    return places;
}

std::vector<std::size_t> elements_in_block(const Discretisation& body, const BlockGrid& grid) {
    const auto& [x, y, z] = grid.axes;
    std::vector<std::size_t> elements;
    elements.reserve(body.space.cells.size());
    for (const auto& cell : body.space.cells) {
        const std::size_t node = grid.nearest_node(body.space.nodes[cell[centre_of_cell]]),
                          row = node / x.n_nodes();
        const std::size_t i = node % x.n_nodes() / 2, j = row % y.n_nodes() / 2,
                          k = row / y.n_nodes() / 2;
        elements.push_back((k * y.n_elements() + j) * x.n_elements() + i);
    }
    return elements;
}

}  // namespace tricontact::fem
