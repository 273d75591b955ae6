#include "fem/planar/pair.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "contact/compliances/interior_parts.h"
#include "fem/planar/whole_section.h"

// Columns of the matrix are displacements by forces, traction times area: with pressures p = f/area
// and the weighted displacements M'u / area, A = D^-1 M' C M D^-1, D the areas.

namespace tricontact::fem::planar {

namespace {

using Dense = Eigen::MatrixXd;
using MatrixPart = Eigen::Map<const Dense, 0, Eigen::OuterStride<>>;

/// Component blocks of the pair: 0 along the surface, 1 into the substrate.
using ByComponent = std::array<std::array<Dense, 2>, 2>;

Eigen::SparseMatrix<double> matrix_of(const std::vector<ContactGrid::Entry>& entries,
                                      Eigen::Index n_rows, Eigen::Index n_points) {
    std::vector<Eigen::Triplet<double>> triplets;
    for (const auto& [node, point, value] : entries) triplets.emplace_back(node, point, value);
    Eigen::SparseMatrix<double> matrix(n_rows, n_points);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

ByComponent blocks_of(const std::vector<CondensedSection>& bodies, const ContactGrid& grid) {
    const auto m = static_cast<Eigen::Index>(grid.size());
    const Eigen::VectorXd inverse =
        Eigen::Map<const Eigen::VectorXd>(grid.area.data(), m).cwiseInverse();
    ByComponent blocks;
    for (auto& row : blocks) row.fill(Dense::Zero(m, m));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const auto n = static_cast<Eigen::Index>(bodies[b].size());
        const Eigen::SparseMatrix<double> mean =
            matrix_of(grid.transfer[b], n, m) * inverse.asDiagonal();
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
    points.is_whole_face = options.is_whole_face;
    if (!line) return points;
    for (double& area : points.area) area *= (options.halves ? 2 : 1) * options.length;
    points.line_length = options.length;
    return points;
}

/// Of the direction in which a point is pressed, along the approach of the bodies.
double share_of_approach(const PairOptions& options, double along) {
    return options.conforming ? std::cos(along / options.radius) : 1;
}

/// What a traction along the surface of q = 0 presses: see pair_compliance().
double slope_of(const PairOptions& options, double along) {
    return options.conforming && options.with_friction ? std::tan(along / options.radius) : 0;
}

/// By points, of each body: see SectionCompliance.
std::vector<std::vector<double>> missing_by_points(const std::vector<CondensedSection>& bodies,
                                                   const ContactGrid& grid,
                                                   const PairOptions& options) {
    std::vector<std::vector<double>> missing;
    const std::size_t n_points = grid.size();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        auto& of_body = missing.emplace_back(2 * n_points, 0.);
        for (const auto& [node, point, value] : grid.transfer[b]) {
            const double along = grid.along[point], weight = value / grid.area[point];
            const double by_traction = bodies[b].missing_reaction[node],
                         by_pressure = bodies[b].missing_reaction[bodies[b].size() + node];
            of_body[point] += weight * (by_traction + slope_of(options, along) * by_pressure);
            of_body[n_points + point] += weight * by_pressure / share_of_approach(options, along);
        }
    }
    return missing;
}

/// T C T' of a conforming contact with friction, T from displacements along arc and radius to v and
/// w: [1, tan; 0, 1/cos].
std::vector<double> along_z(const ByComponent& blocks, const ContactGrid& grid,
                            const PairOptions& options, double per_force) {
    const auto n = static_cast<Eigen::Index>(grid.size());
    Eigen::VectorXd slope(n), share(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        slope[i] = slope_of(options, grid.along[i]);
        share[i] = 1 / share_of_approach(options, grid.along[i]);
    }
    const auto tan = slope.asDiagonal(), over_cos = share.asDiagonal();
    const Dense along =
        blocks[0][0] + tan * blocks[1][0] + blocks[0][1] * tan + tan * blocks[1][1] * tan;
    const Dense across = (blocks[0][1] + tan * blocks[1][1]) * over_cos;
    const Dense down = over_cos * blocks[1][1] * over_cos;
    std::vector<double> matrix(9 * n * n, 0);
    Eigen::Map<Dense> all(matrix.data(), 3 * n, 3 * n);
    all.block(0, 0, n, n) = per_force * along;
    all.block(0, 2 * n, n, n) = per_force * across;
    all.block(2 * n, 0, n, n) = per_force * across.transpose();
    all.block(2 * n, 2 * n, n, n) = per_force * down;
    return matrix;
}

}  // namespace

std::optional<std::array<double, 3>> SectionCompliance::missing_reaction(
    std::span<const double> p, const contact::TangentialField& t) const {
    const std::size_t n = p.size();
    double worst = 0;
    for (const auto& of_body : missing_) {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
            sum += points().area[i] * (of_body[i] * t.x[i] + of_body[n + i] * p[i]);
        if (std::abs(sum) > std::abs(worst)) worst = sum;
    }
    return std::array<double, 3>{0, 0, worst};
}

std::unique_ptr<const contact::Interior> SectionCompliance::interior(
    std::span<const double> p, const contact::TangentialField& t) const {
    if (parts_.empty()) return nullptr;
    auto both = std::make_unique<contact::Interior>();
    std::optional<contact::Interior> indenter;
    for (const Part& part : parts_) {
        std::vector<double> forces(2 * part.n_nodes, 0);
        for (const auto& [node, point, value] : part.transfer) {
            const double share = share_of_approach(options_, points().x[point]);
            forces[node] += value * t.x[point];
            forces[part.n_nodes + node] +=
                value * (p[point] / share + slope_of(options_, points().x[point]) * t.x[point]);
        }
        // Both are condensed under what presses the substrate; it is the other way round on the
        // body that presses.
        contact::Interior inside = part.body->interior(forces, part.presses ? -1 : 1,
                                                       options_.length, options_.halves ? 2 : 1);
        if (part.presses)
            indenter = contact::as_indenter(std::move(inside));
        else
            *both = std::move(inside);
    }
    for (std::size_t i = 0; i < p.size(); ++i) both->applied[2] -= points().area[i] * p[i];
    if (indenter) *both = contact::joined_bodies(std::move(*both), *indenter);
    return both;
}

std::unique_ptr<SectionCompliance> pair_compliance(const std::vector<CondensedSection>& bodies,
                                                   const ContactGrid& grid,
                                                   const PairOptions& options) {
    const Solid solid = bodies.front().solid;
    const ByComponent blocks = blocks_of(bodies, grid);
    const std::size_t n = grid.size();
    const double per_force =
        solid == Solid::plane_strain ? 1 / ((options.halves ? 2 : 1) * options.length) : 1;
    std::vector<double> matrix(9 * n * n, 0);
    constexpr std::array<std::size_t, 2> component{0, 2};
    const auto share = [&](std::size_t i) { return share_of_approach(options, grid.along[i]); };
    for (int c = 0; c < 2; ++c)
        for (int r = 0; r < 2; ++r)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t i = 0; i < n; ++i)
                    matrix[(component[c] * n + k) * 3 * n + component[r] * n + i] =
                        per_force *
                        blocks[r][c](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) /
                        (share(i) * share(k));
    if (options.conforming && options.with_friction)
        matrix = along_z(blocks, grid, options, per_force);
    auto pair =
        std::make_unique<SectionCompliance>(points_of(grid, solid, options), std::move(matrix),
                                            missing_by_points(bodies, grid, options));
    std::vector<SectionCompliance::Part> parts;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        parts.push_back(
            {bodies[b].whole, grid.transfer[b], bodies[b].size(), options.first_presses && b == 0});
    pair->set_parts(std::move(parts), options);
    pair->set_pinned(std::ranges::any_of(bodies, &CondensedSection::is_pinned));
    return pair;
}

}  // namespace tricontact::fem::planar
