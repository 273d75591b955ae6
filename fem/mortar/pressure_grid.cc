#include "fem/mortar/pressure_grid.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "fem/mortar/overlap.h"

namespace tricontact::fem {

using contact::ContactPoints;
using contact::Vector2;

namespace {

constexpr double uncovered = 1e-12;  // of an area, for rounding

double area_of(const Rectangle& r) {
    return (r.high[0] - r.low[0]) * (r.high[1] - r.low[1]);
}

bool meet(const SeenFace& face, const Rectangle& r) {
    const Vector2 low = face.low(), high = face.high();
    return low[0] < r.high[0] && high[0] > r.low[0] && low[1] < r.high[1] && high[1] > r.low[1];
}

Rectangle bounding_box(const ContactPoints& surface) {
    const auto [x_low, x_high] = std::ranges::minmax(surface.x);
    const auto [y_low, y_high] = std::ranges::minmax(surface.y);
    return {{x_low, y_low}, {x_high, y_high}};
}

/// Cells of a grid between its points.
struct GridCells {
    const ContactPoints& grid;

    Rectangle cell(int i, int j) const {
        const std::size_t low = static_cast<std::size_t>(j) * grid.n_x + i,
                          high = low + grid.n_x + 1;
        return {{grid.x[low], grid.y[low]}, {grid.x[high], grid.y[high]}};
    }
    /// Cells from ... to along d whose interval meets [low, high].
    std::array<int, 2> range(int d, double low, double high) const {
        const int n = (d == 0 ? grid.n_x : grid.n_y) - 1;
        const auto index = [&](double x) {
            return static_cast<int>(std::floor((x - grid.first[d]) / grid.spacing[d]));
        };
        return {std::clamp(index(low) - 1, 0, n), std::clamp(index(high) + 2, 0, n)};
    }
};

void add_overlap(const SeenFace& face, const ContactPoints& grid, int i, int j,
                 std::vector<PressureTransfer::Entry>& entries) {
    const Rectangle cell = GridCells{grid}.cell(i, j);
    std::array<std::array<double, 4>, 9> sum{};
    integrate_shared(face, cell, [&](const Vector2& x, double weight) {
        const auto place = face.place_of(x);
        if (!place) throw contact::InputError("mesh: a contact face is too distorted to be seen");
        const auto phi = biquadratic((*place)[0], (*place)[1]);
        const double s = (x[0] - cell.low[0]) / (cell.high[0] - cell.low[0]);
        const double t = (x[1] - cell.low[1]) / (cell.high[1] - cell.low[1]);
        const std::array<double, 4> psi{(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
        for (int a = 0; a < 9; ++a)
            for (int b = 0; b < 4; ++b) sum[a][b] += weight * phi[a] * psi[b];
    });
    const int first = j * grid.n_x + i;
    const std::array<int, 4> points{first, first + 1, first + grid.n_x, first + grid.n_x + 1};
    for (int a = 0; a < 9; ++a)
        for (int b = 0; b < 4; ++b)
            if (sum[a][b] != 0) entries.push_back({face.nodes[a], points[b], sum[a][b]});
}

using Sparse = Eigen::SparseMatrix<double>;
using Dense = Eigen::MatrixXd;

/// M over the areas of its columns, on the modelled half of a mirrored body.
Sparse mean_matrix(const PressureTransfer& transfer) {
    std::vector<double> area(transfer.n_points, 0);
    for (const auto& entry : transfer.entries) area[entry.point] += entry.value;
    std::vector<Eigen::Triplet<double>> triplets;
    for (const auto& [node, point, value] : transfer.entries)
        triplets.emplace_back(node, point, value / area[point]);
    Sparse mean(transfer.n_nodes, transfer.n_points);
    mean.setFromTriplets(triplets.begin(), triplets.end());
    return mean;
}

/// Of a mirrored contact nothing moves or pulls along y in the plane of symmetry.
std::vector<bool> held_along_y(const ContactPoints& grid) {
    std::vector<bool> held(grid.size(), false);
    for (std::size_t i = 0; i < grid.size(); ++i) held[i] = grid.mirrored && grid.y[i] == 0;
    return held;
}

}  // namespace

double covered_area(const ContactPoints& surface, const Rectangle& rectangle) {
    double sum = 0;
    for (const SeenFace& face : seen_faces(surface))
        if (meet(face, rectangle)) sum += shared_area(face, rectangle);
    return sum;
}

std::optional<Rectangle> shared_rectangle(std::span<const ContactPoints* const> surfaces) {
    Rectangle box = bounding_box(*surfaces.front());
    for (const ContactPoints* const surface : surfaces) {
        const Rectangle other = bounding_box(*surface);
        for (int d = 0; d < 2; ++d) {
            box.low[d] = std::max(box.low[d], other.low[d]);
            box.high[d] = std::min(box.high[d], other.high[d]);
        }
    }
    if (!(box.high[0] > box.low[0]) || !(box.high[1] > box.low[1])) return std::nullopt;
    const bool mirrored = surfaces.front()->mirrored;
    const auto scaled = [&](double part) {
        Rectangle r = box;
        for (int d = 0; d < 2; ++d) {
            const double middle = mirrored && d == 1 ? 0 : (box.low[d] + box.high[d]) / 2;
            r.low[d] = middle + part * (box.low[d] - middle);
            r.high[d] = middle + part * (box.high[d] - middle);
        }
        return r;
    };
    const auto is_covered = [&](const Rectangle& r) {
        return std::ranges::all_of(surfaces, [&](const ContactPoints* surface) {
            return covered_area(*surface, r) >= (1 - uncovered) * area_of(r);
        });
    };
    if (is_covered(box)) return box;
    double least = 0, most = 1;
    for (int k = 0; k < 24; ++k) {
        const double middle = (least + most) / 2;
        (is_covered(scaled(middle)) ? least : most) = middle;
    }
    if (least < 1e-3) return std::nullopt;
    return scaled(least);
}

double node_spacing(const ContactPoints& surface, const Rectangle& rectangle) {
    double longest = 0;
    for (const SeenFace& face : seen_faces(surface))
        if (meet(face, rectangle)) longest = std::max(longest, face.longest_edge());
    return longest / 2;
}

ContactPoints pressure_grid(const Rectangle& rectangle, double spacing, bool mirrored) {
    std::array<int, 2> n{};
    Vector2 step{};
    for (int d = 0; d < 2; ++d) {
        const double length = rectangle.high[d] - rectangle.low[d];
        n[d] = std::max(1, static_cast<int>(std::floor(length / spacing * (1 + 1e-9))));
        step[d] = length / n[d];
    }
    ContactPoints grid = ContactPoints::grid(n[0] + 1, n[1] + 1, rectangle.low, step);
    grid.mirrored = mirrored;
    grid.bilinear = true;
    for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i) {
            double& area = grid.area[static_cast<std::size_t>(j) * grid.n_x + i];
            if (i == 0 || i == n[0]) area /= 2;
            if (j == 0 || j == n[1]) area /= 2;
            if (mirrored) area *= 2;
        }
    return grid;
}

PressureTransfer transfer_to(const ContactPoints& surface, const ContactPoints& grid) {
    PressureTransfer transfer{static_cast<int>(surface.size()), static_cast<int>(grid.size()), {}};
    const GridCells cells{grid};
    for (const SeenFace& face : seen_faces(surface)) {
        const Vector2 low = face.low(), high = face.high();
        const auto along_x = cells.range(0, low[0], high[0]),
                   along_y = cells.range(1, low[1], high[1]);
        for (int j = along_y[0]; j < along_y[1]; ++j)
            for (int i = along_x[0]; i < along_x[1]; ++i)
                if (meet(face, cells.cell(i, j))) add_overlap(face, grid, i, j, transfer.entries);
    }
    std::vector<double> area(grid.size(), 0);
    for (const auto& entry : transfer.entries) area[entry.point] += entry.value;
    for (std::size_t k = 0; k < area.size(); ++k) {
        const double whole = grid.area[k] * (grid.mirrored ? .5 : 1);
        if (std::abs(area[k] - whole) > 1e-6 * whole)
            throw contact::InputError(fmt::format(
                "mesh: the contact surface covers {:.4g} of its place about x = {:.6g} m, "
                "y = {:.6g} m; name a surface without gaps or folds \"contact\"",
                area[k] / whole, grid.x[k], grid.y[k]));
    }
    return transfer;
}

std::vector<double> weighted_means(const PressureTransfer& transfer,
                                   std::span<const double> field) {
    std::vector<double> area(transfer.n_points, 0), sum(transfer.n_points, 0);
    for (const auto& [node, point, value] : transfer.entries) {
        area[point] += value;
        sum[point] += value * field[node];
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= area[k];
    return sum;
}

ContactPoints grid_on_nodes(const ContactPoints& patch) {
    const Vector2 last{patch.x.back(), patch.y.back()};
    return pressure_grid({patch.first, last}, patch.spacing[0], patch.mirrored);
}

// As many points as nodes: in place, since most of the memory is in the matrix.
CondensedLayer on_grid(CondensedLayer body, const ContactPoints& grid,
                       const PressureTransfer& transfer) {
    const Sparse mean = mean_matrix(transfer);
    const auto n = mean.rows(), m = mean.cols();
    const std::vector<bool> held = held_along_y(grid);
    CondensedLayer seen;
    seen.points = grid;
    std::vector<double> apart = n == m ? std::vector<double>() : large_field(9 * m * m);
    std::vector<double>& seen_compliance = n == m ? body.compliance : apart;
    using Block = Eigen::Map<const Dense, 0, Eigen::OuterStride<>>;
    using Target = Eigen::Map<Dense, 0, Eigen::OuterStride<>>;
    const auto is_held = [&](int component, Eigen::Index k) { return component == 1 && held[k]; };
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            const Block block(body.compliance.data() + (c * n) * 3 * n + r * n, n, n,
                              Eigen::OuterStride<>(3 * n));
            Target to(seen_compliance.data() + (c * m) * 3 * m + r * m, m, m,
                      Eigen::OuterStride<>(3 * m));
            const Dense by_points = block * mean;
            to = mean.transpose() * by_points;
            for (Eigen::Index k = 0; k < m; ++k) {
                if (is_held(c, k)) to.col(k).setZero();
                if (is_held(r, k)) to.row(k).setZero();
            }
        }
    seen.compliance = std::move(seen_compliance);
    for (int d = 0; d < 3; ++d) {
        seen.missing_reaction[d].resize(3 * m);
        for (int c = 0; c < 3; ++c) {
            const Eigen::Map<const Eigen::VectorXd> by_nodes(
                body.missing_reaction[d].data() + c * n, n);
            Eigen::Map<Eigen::VectorXd>(seen.missing_reaction[d].data() + c * m, m) =
                mean.transpose() * by_nodes;
        }
    }
    return seen;
}

}  // namespace tricontact::fem
