#include "fem/planar/pair.h"

#include <Eigen/Dense>
#include <cmath>

// Columns of the matrix are displacements by forces, traction times area: with pressures p = f/area
// and the weighted displacements M'u / area, A = D^-1 M' C M D^-1, D the areas.

namespace tricontact::fem::planar {

namespace {

using Dense = Eigen::MatrixXd;
using MatrixPart = Eigen::Map<const Dense, 0, Eigen::OuterStride<>>;

/// Component blocks of the pair: 0 along the surface, 1 into the substrate.
using ByComponent = std::array<std::array<Dense, 2>, 2>;

ByComponent blocks_of(const std::vector<CondensedBody>& bodies, const ContactGrid& grid) {
    const auto m = static_cast<Eigen::Index>(grid.size());
    const Eigen::VectorXd inverse =
        Eigen::Map<const Eigen::VectorXd>(grid.area.data(), m).cwiseInverse();
    ByComponent blocks;
    for (auto& row : blocks) row.fill(Dense::Zero(m, m));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const auto n = static_cast<Eigen::Index>(bodies[b].size());
        const Eigen::SparseMatrix<double> mean = grid.transfer[b] * inverse.asDiagonal();
        for (int r = 0; r < 2; ++r)
            for (int c = 0; c < 2; ++c) {
                const MatrixPart part(bodies[b].compliance.data() + (c * n) * 2 * n + r * n, n, n,
                                      Eigen::OuterStride<>(2 * n));
                const Dense by_points = part * mean;
                blocks[r][c] += mean.transpose() * by_points;
            }
    }
    return blocks;
}

contact::ContactPoints points_of(const ContactGrid& grid, Solid solid, const PairOptions& options) {
    const int n = static_cast<int>(grid.size());
    const double spacing = n > 1 ? (grid.along.back() - grid.along.front()) / (n - 1) : 0;
    const bool line = solid == Solid::plane_strain;
    auto points = contact::ContactPoints::grid(n, 1, {grid.along.front(), 0},
                                               {spacing, line ? options.length : spacing});
    points.x = grid.along;
    points.local_ratio = options.local_ratio;
    points.area = grid.area;
    if (!line) return points;
    for (double& area : points.area) area *= (options.halves ? 2 : 1) * options.length;
    points.line_length = options.length;
    return points;
}

}  // namespace

std::unique_ptr<DenseCompliance> pair_compliance(const std::vector<CondensedBody>& bodies,
                                                 const ContactGrid& grid,
                                                 const PairOptions& options) {
    const Solid solid = bodies.front().solid;
    const ByComponent blocks = blocks_of(bodies, grid);
    const std::size_t n = grid.size();
    const double per_force =
        solid == Solid::plane_strain ? 1 / ((options.halves ? 2 : 1) * options.length) : 1;
    std::vector<double> matrix(9 * n * n, 0);
    constexpr std::array<std::size_t, 2> component{0, 2};
    const auto share = [&](std::size_t i) {
        return options.conforming ? std::cos(grid.along[i] / options.radius) : 1;
    };
    for (int c = 0; c < 2; ++c)
        for (int r = 0; r < 2; ++r)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t i = 0; i < n; ++i)
                    matrix[(component[c] * n + k) * 3 * n + component[r] * n + i] =
                        per_force *
                        blocks[r][c](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) /
                        (share(i) * share(k));
    return std::make_unique<DenseCompliance>(points_of(grid, solid, options), std::move(matrix));
}

}  // namespace tricontact::fem::planar
