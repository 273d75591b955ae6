#include "bem/grid_interior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "bem/interior_transform.h"
#include "bem/plane_layer_influence.h"

namespace tricontact::bem {

namespace {

constexpr int most_cells = 256;    // along a side, before blocks are made
constexpr int most_points = 128;   // along a side, before they are thinned
constexpr double thinning = 1.25;  // of neighbouring steps between points outside
constexpr double fine_steps = 25;  // of depth, over the contact radius
constexpr double deeper = 1.2;     // growth of the steps below it

/// Cells of the contact grid, or blocks of them, along one side.
struct Side {
    int n;         // blocks over the contact grid
    int margin;    // blocks beyond it, on either side
    int block;     // cells of a block, odd
    int middle;    // cell in the middle of the block in the middle
    double first;  // centre of the first block of the margin [m]
    double spacing;

    int size() const { return n + 2 * margin; }
    int block_of(int cell) const {
        const int from_first = cell - middle + block / 2 + block * (n / 2);
        return margin + from_first / block;
    }
};

Side make_side(int n_cells, double first, double spacing, double margin) {
    int block = 1;
    while ((n_cells + block - 1) / block > most_cells) block += 2;
    const int middle = (n_cells - 1) / 2;
    const int beside = (std::max(middle, n_cells - 1 - middle) + block / 2) / block;
    Side side{.n = 2 * beside + 1,
              .margin = static_cast<int>(std::ceil(margin / (block * spacing))),
              .block = block,
              .middle = middle,
              .first = 0,
              .spacing = block * spacing};
    side.first = first + middle * spacing - (beside + side.margin) * side.spacing;
    return side;
}

std::array<Side, 2> make_sides(const contact::ContactPoints& grid, bool plane_strain) {
    const double length_x = grid.n_x * grid.spacing[0], length_y = grid.n_y * grid.spacing[1];
    const double margin = (plane_strain ? length_x : std::min(length_x, length_y)) / 2;
    return {make_side(grid.n_x, grid.first[0], grid.spacing[0], margin),
            make_side(grid.n_y, grid.first[1], grid.spacing[1], plane_strain ? 0 : margin)};
}

/// Blocks whose centres become points, from the middle outwards.
std::vector<int> points_of(const Side& side) {
    const int middle = side.margin + side.n / 2, stride = (side.n + most_points - 1) / most_points;
    std::vector<int> beside;
    double step = stride;
    for (double i = stride; i <= middle; i += std::floor(step)) {
        beside.push_back(static_cast<int>(i));
        if (i > side.n / 2) step *= thinning;
    }
    std::vector<int> points{middle};
    for (const int i : beside) {
        points.insert(points.begin(), middle - i);
        points.push_back(middle + i);
    }
    return points;
}

/// Mean traction of the blocks, x fastest.
std::vector<double> by_blocks(std::span<const double> traction, int n_x,
                              const std::array<Side, 2>& sides) {
    const auto& [x, y] = sides;
    std::vector<double> mean(static_cast<std::size_t>(x.size()) * y.size(), 0.0);
    for (std::size_t i = 0; i < traction.size(); ++i) {
        const int column = static_cast<int>(i) % n_x, row = static_cast<int>(i) / n_x;
        mean[static_cast<std::size_t>(y.block_of(row)) * x.size() + x.block_of(column)] +=
            traction[i] / (x.block * y.block);
    }
    return mean;
}

double product(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

std::vector<double> coordinates(const Side& side, const std::vector<int>& points) {
    std::vector<double> out;
    for (const int i : points) out.push_back(side.first + i * side.spacing);
    return out;
}

/// The tractions, what they make, and where it goes.
struct Problem {
    std::array<Side, 2> sides;
    std::array<std::vector<double>, 3> tractions;  // x, y, pressing
    std::array<std::vector<int>, 2> points;
    InteriorTransform transform;
    contact::Interior interior;
};

/// Hands the values of one field at one depth to `store`, with the points they belong to.
template <typename Store>
void pick(const Problem& problem, std::span<const double> field, std::size_t level, Store store) {
    const auto& [columns, rows] = problem.points;
    // Depths increase downwards, z upwards.
    const std::size_t plane = problem.interior.axes[2].size() - 1 - level;
    std::size_t to = plane * columns.size() * rows.size();
    for (const int j : rows)
        for (const int i : columns)
            store(to++, field[static_cast<std::size_t>(j) * problem.sides[0].size() + i]);
}

/// Of one block at a depth, so many blocks away.
using Response = std::function<theory::InteriorResponse(std::size_t level, int i, int j)>;

Response response_of(const InteriorView& view, const std::array<Side, 2>& sides) {
    const double h_x = sides[0].spacing, h_y = sides[1].spacing;
    const double length_x = sides[0].size() * h_x, length_y = sides[1].size() * h_y;
    if (view.body.plane_strain) {
        const auto strip = std::make_shared<const PlaneInteriorInfluence>(
            view.body.layers.value(), h_x, view.depths, length_x);
        return [=](std::size_t level, int i, int) { return strip->at(level, i * h_x); };
    }
    const auto cell = std::make_shared<const InteriorInfluence>(
        view.body, contact::Vector2{h_x, h_y}, view.depths, std::hypot(length_x, length_y));
    return [=](std::size_t level, int i, int j) { return cell->at(level, i * h_x, j * h_y); };
}

void fill_level(const Response& response, std::size_t level, Problem& problem,
                std::array<double, 3>& surface_work) {
    const bool square = problem.sides[0].spacing == problem.sides[1].spacing;
    InteriorTransform::Level transform(
        problem.transform, [&](int i, int j) { return response(level, i, j); }, square);
    auto& interior = problem.interior;
    for (int c = 0; c < 3; ++c) {
        const double sign = c == 2 ? -1 : 1;
        const auto field = transform.displacement(c);
        pick(problem, field, level,
             [&](std::size_t k, double value) { interior.displacement[k][c] = sign * value; });
        if (level == 0) surface_work[c] = product(problem.tractions[c], field);
    }
    for (int c = 0; c < 6; ++c) {
        const double sign = c >= 4 ? -1 : 1;  // YZ and XZ
        pick(problem, transform.stress(c), level,
             [&](std::size_t k, double value) { interior.stress[k][c] = sign * value; });
    }
}

Problem make_problem(const InteriorView& view, const contact::ContactPoints& grid,
                     std::span<const double> p, const contact::TangentialField& t) {
    const auto sides = make_sides(grid, view.body.plane_strain);
    std::array<std::vector<double>, 3> tractions = {by_blocks(t.x, grid.n_x, sides),
                                                    by_blocks(t.y, grid.n_x, sides),
                                                    by_blocks(p, grid.n_x, sides)};
    InteriorTransform transform(sides[0].size(), sides[1].size(), tractions);
    Problem problem{.sides = sides,
                    .tractions = std::move(tractions),
                    .points = {points_of(sides[0]), points_of(sides[1])},
                    .transform = std::move(transform),
                    .interior = {}};
    auto& interior = problem.interior;
    for (int d = 0; d < 2; ++d) interior.axes[d] = coordinates(sides[d], problem.points[d]);
    for (auto depth = view.depths.rbegin(); depth != view.depths.rend(); ++depth)
        interior.axes[2].push_back(*depth > 0 ? -*depth : 0);
    const std::size_t n =
        interior.axes[0].size() * interior.axes[1].size() * interior.axes[2].size();
    interior.displacement.resize(n);
    interior.stress.resize(n);
    return problem;
}

}  // namespace

std::vector<double> interior_depths(double spacing, double contact_radius, double depth) {
    std::vector<double> depths{0};
    double step = std::max(spacing, contact_radius / fine_steps);
    while (depths.back() + 1.5 * step < depth) {
        depths.push_back(depths.back() + step);
        if (depths.back() > contact_radius) step *= deeper;
    }
    depths.push_back(depth);
    return depths;
}

contact::Interior grid_interior(const InteriorView& view, const contact::ContactPoints& grid,
                                std::span<const double> p, const contact::TangentialField& t) {
    Problem problem = make_problem(view, grid, p, t);
    const auto& [x, y] = problem.sides;
    const Response response = response_of(view, problem.sides);
    std::array<double, 3> work{};
#pragma omp parallel for num_threads(view.n_threads) if (view.n_threads > 1) schedule(dynamic)
    for (std::size_t level = 0; level < view.depths.size(); ++level)
        fill_level(response, level, problem, work);

    const double area = x.spacing * y.spacing;
    problem.interior.strain_energy = area / 2 * (work[0] + work[1] + work[2]);
    for (int d = 0; d < 3; ++d) {
        double sum = 0;
        for (const double traction : problem.tractions[d]) sum += traction;
        problem.interior.applied[d] = (d == 2 ? -area : area) * sum;
    }
    return std::move(problem.interior);
}

}  // namespace tricontact::bem
