#include "report/lazy_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tricontact::report {

namespace {

constexpr int n_points = 4;

/// Lagrange's polynomials of the points 0, 1, 2, 3 at t.
std::array<double, n_points> lagrange(double t) {
    std::array<double, n_points> weights{1, 1, 1, 1};
    for (int i = 0; i < n_points; ++i)
        for (int j = 0; j < n_points; ++j)
            if (j != i) weights[i] *= (t - j) / (i - j);
    return weights;
}

/// First of four points with `position` between the middle two.
int first_point(double position) {
    return static_cast<int>(std::floor(position)) - 1;
}

}  // namespace

LazyTable::LazyTable(TableNode node, double x_step, double z_step, Rows rows)
    : node_(std::move(node)), x_step_(x_step), z_step_(z_step), rows_(rows) {
    const int n_rows = rows.last - rows.first + 1;
    if (n_rows != 1 && n_rows < n_points) throw std::invalid_argument("one row, or four and more");
}

const std::vector<double>& LazyTable::node(int i, int k) {
    const auto found = nodes_.find({i, k});
    if (found != nodes_.end()) return found->second;
    return nodes_[{i, k}] = node_(i * x_step_, k * z_step_);
}

std::vector<double> LazyTable::at(double x, double z) {
    const int i = first_point(x / x_step_);
    const auto x_weights = lagrange(x / x_step_ - i);
    const bool plane = rows_.first != rows_.last;
    const int k = plane
                      ? std::clamp(first_point(z / z_step_), rows_.first, rows_.last - n_points + 1)
                      : rows_.first;
    const auto z_weights = plane ? lagrange(z / z_step_ - k) : std::array<double, n_points>{1};
    std::vector<double> values;
    for (int p = 0; p < n_points; ++p)
        for (int q = 0; q < (plane ? n_points : 1); ++q) {
            const auto& at_node = node(i + p, k + q);
            values.resize(at_node.size(), 0.);
            for (std::size_t j = 0; j < values.size(); ++j)
                values[j] += x_weights[p] * z_weights[q] * at_node[j];
        }
    return values;
}

}  // namespace tricontact::report
