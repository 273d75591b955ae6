#include "fem/block/surface_symbol.h"

#include <Eigen/Dense>
#include <vector>

#include "fem/element.h"

// One element of a layer has nodes on its lower, middle and upper plane, on each nine, of which
// four kinds are left once opposite edges are tied by the phases: 36 unknowns. From the base
// upwards the lower and the middle plane are eliminated, what is left is the stiffness of the upper
// one:
//
//   S = K_uu - K_ul (K_ll + S_below)^-1 K_lu.

namespace tricontact::fem {

namespace {

using Complex = std::complex<double>;
constexpr int n_surface = SurfaceSymbol::size, n_below = 2 * n_surface,
              n_layer = n_below + n_surface;
using Layer = Eigen::Matrix<Complex, n_layer, n_layer>;
using Below = Eigen::Matrix<Complex, n_below, n_below>;
using Across = Eigen::Matrix<Complex, n_below, n_surface>;
using Surface = Eigen::Matrix<Complex, n_surface, n_surface>;

/// A column of bricks, one upon the other.
meshes::HexMesh column(const BlockGrid& grid, double edge_x, double edge_y) {
    meshes::HexMesh mesh;
    const auto& planes = grid.axes[2].planes;
    for (const double z : planes)
        for (const auto& [x, y] :
             {std::array{0., 0.}, {edge_x, 0.}, {edge_x, edge_y}, {0., edge_y}})
            mesh.nodes.push_back({x, y, z});
    for (int k = 0; k + 1 < static_cast<int>(planes.size()); ++k) {
        auto& hex = mesh.hexes.emplace_back();
        for (int v = 0; v < 8; ++v) hex[v] = 4 * k + v;
        mesh.regions.push_back(meshes::Region::layer);
        for (int side = 0; side < 4; ++side) {
            const int next = (side + 1) % 4;
            mesh.faces.push_back({{4 * k + side, 4 * k + next, 4 * k + 4 + next, 4 * k + 4 + side},
                                  meshes::Boundary::sides});
        }
    }
    const int top = 4 * static_cast<int>(planes.size() - 1);
    mesh.faces.push_back({{0, 3, 2, 1}, meshes::Boundary::base});
    mesh.faces.push_back({{top, top + 1, top + 2, top + 3}, meshes::Boundary::contact});
    return mesh;
}

}  // namespace

struct SurfaceSymbol::Parts {
    std::vector<ElementStiffness> layers;
    std::uint8_t held = 0;                  // at the base
    std::array<int, 81> unknown{}, wrap{};  // of a row of an element: where, by which phases

    Layer tied(const ElementStiffness& k, const std::array<Complex, 4>& phase) const {
        std::array<std::array<Complex, 4>, 4> weight;
        for (int m = 0; m < 4; ++m)
            for (int n = 0; n < 4; ++n) weight[m][n] = std::conj(phase[m]) * phase[n];
        Layer tied = Layer::Zero();
        for (int c = 0; c < 81; ++c)
            for (int r = 0; r < 81; ++r)
                tied(unknown[r], unknown[c]) += weight[wrap[r]][wrap[c]] * k[c][r];
        return tied;
    }
};

SurfaceSymbol::SurfaceSymbol(const BlockGrid& grid, double edge_x, double edge_y)
    : parts_(std::make_unique<Parts>()) {
    const Q2Space space(column(grid, edge_x, edge_y));
    ElementValues values(space, 3);
    parts_->layers.resize(space.cells.size());
    for (std::size_t e = 0; e < space.cells.size(); ++e) {
        values.reinit(e);
        element_stiffness(values, grid.moduli[e], parts_->layers[e]);
    }
    parts_->held = grid.axes[2].held[0];
    for (int a = 0; a < 3; ++a)
        for (int i = 0; i < 27; ++i) {
            const auto& [x, y, z] = node_positions[i];
            parts_->unknown[a * 27 + i] = n_surface * z + 3 * (x % 2 + 2 * (y % 2)) + a;
            parts_->wrap[a * 27 + i] = x / 2 + 2 * (y / 2);
        }
}

SurfaceSymbol::~SurfaceSymbol() = default;

SurfaceSymbol::Matrix SurfaceSymbol::compliance(double phase_x, double phase_y,
                                                double drift) const {
    const Complex p_x = std::polar(1., phase_x), p_y = std::polar(1., phase_y);
    const std::array<Complex, 4> phase{1., p_x, p_y, p_x * p_y};
    Surface surface = drift * Surface::Identity();
    bool at_base = true;
    for (const ElementStiffness& layer : parts_->layers) {
        const Layer k = parts_->tied(layer, phase);
        Below below = k.topLeftCorner<n_below, n_below>();
        Across across = k.topRightCorner<n_below, n_surface>();
        below.topLeftCorner<n_surface, n_surface>() += surface;
        for (int u = 0; at_base && u < n_surface; ++u)
            if (parts_->held >> u % 3 & 1) {
                const Complex own = below(u, u);
                below.row(u).setZero();
                below.col(u).setZero();
                across.row(u).setZero();
                below(u, u) = own;
            }
        at_base = false;
        surface = k.bottomRightCorner<n_surface, n_surface>() -
                  across.adjoint() * below.ldlt().solve(across);
    }
    const Surface inverse = surface.ldlt().solve(Surface::Identity());
    Matrix matrix;
    for (int c = 0; c < n_surface; ++c)
        for (int r = 0; r < n_surface; ++r)
            matrix[c * n_surface + r] = .5 * (inverse(r, c) + std::conj(inverse(c, r)));
    return matrix;
}

}  // namespace tricontact::fem
