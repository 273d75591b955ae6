#include "statistics/growing_least_squares.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tricontact::statistics {

namespace {

using ColumnView = Eigen::Map<const Eigen::VectorXd>;
using ColumnsView = Eigen::Map<const Eigen::MatrixXd>;

// What is left of a column over its length: below this it is made of rounding errors.
constexpr double least_independent_part = 1e-10;
// 1 - h_i: below this the value is fitted by a coefficient of its own, but for rounding.
constexpr double least_freedom = 1e-10;

ColumnView column_view(std::span<const double> v) {
    return {v.data(), static_cast<Eigen::Index>(v.size())};
}

}  // namespace

GrowingLeastSquares::GrowingLeastSquares(std::vector<double> values)
    : values_(std::move(values)), residuals_(values_), leverages_(values_.size(), 0.) {}

bool GrowingLeastSquares::append(std::span<const double> column) {
    const auto n = static_cast<Eigen::Index>(values_.size());
    const auto m = static_cast<Eigen::Index>(n_columns());
    if (m == n) return false;
    const ColumnsView q(orthonormal_.data(), n, m);
    Eigen::VectorXd rest = column_view(column), factors = Eigen::VectorXd::Zero(m);
    const double length = rest.norm();
    for (int pass = 0; pass < 2; ++pass) {
        const Eigen::VectorXd part = q.transpose() * rest;
        rest.noalias() -= q * part;
        factors += part;
    }
    const double diagonal = rest.norm();
    if (!(diagonal > least_independent_part * length)) return false;
    rest /= diagonal;
    // Of the residuals, which are orthogonal to the columns before: fewer digits cancel.
    const double projection = rest.dot(column_view(residuals_));
    for (Eigen::Index i = 0; i < n; ++i) {
        residuals_[static_cast<std::size_t>(i)] -= projection * rest[i];
        leverages_[static_cast<std::size_t>(i)] += rest[i] * rest[i];
    }
    // R^-1 of one more column: -R^-1 s/rho above 1/rho.
    std::vector<double> inverse(static_cast<std::size_t>(m) + 1, 0.);
    for (Eigen::Index k = 0; k < m; ++k) {
        const auto& of_column = inverse_[static_cast<std::size_t>(k)];
        for (std::size_t row = 0; row < of_column.size(); ++row)
            inverse[row] -= of_column[row] * factors[k] / diagonal;
    }
    inverse.back() = 1 / diagonal;
    for (const double entry : inverse) inverse_trace_ += entry * entry;
    inverse_.push_back(std::move(inverse));
    factors_.emplace_back(factors.begin(), factors.end()).push_back(diagonal);
    orthonormal_.insert(orthonormal_.end(), rest.begin(), rest.end());
    projections_.push_back(projection);
    return true;
}

double GrowingLeastSquares::leave_one_out_square() const {
    double sum = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const double freedom = 1 - leverages_[i];
        if (freedom < least_freedom) return std::numeric_limits<double>::infinity();
        const double left_out = residuals_[i] / freedom;
        sum += left_out * left_out;
    }
    return sum / static_cast<double>(values_.size());
}

std::vector<double> GrowingLeastSquares::coefficients(std::size_t n) const {
    std::vector<double> c(projections_.begin(),
                          projections_.begin() + static_cast<std::ptrdiff_t>(n));
    for (std::size_t k = n; k-- > 0;) {
        c[k] /= factors_[k][k];
        for (std::size_t row = 0; row < k; ++row) c[row] -= factors_[k][row] * c[k];
    }
    return c;
}

std::vector<double> GrowingLeastSquares::leave_one_out_residuals(std::size_t n) const {
    const std::size_t n_rows = values_.size();
    std::vector<double> residuals = values_, leverages(n_rows, 0.);
    for (std::size_t k = 0; k < n; ++k) {
        const double* q = orthonormal_.data() + k * n_rows;
        for (std::size_t i = 0; i < n_rows; ++i) {
            residuals[i] -= projections_[k] * q[i];
            leverages[i] += q[i] * q[i];
        }
    }
    for (std::size_t i = 0; i < n_rows; ++i)
        residuals[i] /= std::max(1 - leverages[i], least_freedom);
    return residuals;
}

}  // namespace tricontact::statistics
