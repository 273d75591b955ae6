#include "statistics/correlations.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>

namespace tricontact::statistics {

namespace {

Eigen::MatrixXd dense(const Correlations::Matrix& rows) {
    const auto n = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = rows[i][j];
    return matrix;
}

}  // namespace

void Correlations::add(const std::string& first, const std::string& second, double coefficient) {
    if (!(coefficient > -1 && coefficient < 1))
        throw std::invalid_argument("must lie between -1 and 1");
    if (first == second) throw std::invalid_argument("correlates a number with itself");
    for (const Pair& pair : pairs_)
        if ((pair.first == first && pair.second == second) ||
            (pair.first == second && pair.second == first))
            throw std::invalid_argument("is stated twice");
    pairs_.push_back({first, second, coefficient});
}

Correlations::Matrix Correlations::of(const std::vector<std::string>& names) const {
    const auto at = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    Matrix matrix;
    for (const auto& [first, second, coefficient] : pairs_) {
        const std::size_t i = at(first), j = at(second);
        if (i == names.size() || j == names.size()) continue;
        if (matrix.empty()) {
            matrix.assign(names.size(), std::vector<double>(names.size(), 0.));
            for (std::size_t k = 0; k < names.size(); ++k) matrix[k][k] = 1;
        }
        matrix[i][j] = matrix[j][i] = coefficient;
    }
    return matrix;
}

bool Correlations::is_possible(const std::vector<std::string>& names) const {
    const Matrix matrix = of(names);
    return matrix.empty() || Eigen::LLT<Eigen::MatrixXd>(dense(matrix)).info() == Eigen::Success;
}

double combined_variance(const std::vector<double>& changes,
                         const Correlations::Matrix& correlation) {
    double sum = 0;
    for (std::size_t i = 0; i < changes.size(); ++i)
        for (std::size_t j = 0; j < changes.size(); ++j) {
            const double r = correlation.empty() ? (i == j ? 1. : 0.) : correlation[i][j];
            sum += changes[i] * r * changes[j];
        }
    return sum;
}

double covariance_part(const std::vector<double>& changes,
                       const Correlations::Matrix& correlation) {
    return combined_variance(changes, correlation) - combined_variance(changes, {});
}

Correlations::Matrix triangular_root(const Correlations::Matrix& correlation, std::size_t n) {
    Correlations::Matrix root(n, std::vector<double>(n, 0.));
    if (correlation.empty()) {
        for (std::size_t i = 0; i < n; ++i) root[i][i] = 1;
        return root;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(dense(correlation));
    if (factor.info() != Eigen::Success)
        throw std::invalid_argument("the correlations are not positive definite");
    const Eigen::MatrixXd lower = factor.matrixL();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            root[i][j] = lower(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    return root;
}

std::vector<double> correlated(const Correlations::Matrix& root,
                               const std::vector<double>& independent) {
    std::vector<double> result(independent.size(), 0.);
    for (std::size_t i = 0; i < independent.size(); ++i)
        for (std::size_t k = 0; k <= i; ++k) result[i] += root[i][k] * independent[k];
    return result;
}

}  // namespace tricontact::statistics
