#include "statistics/joint_covariance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/special_values.h"

namespace tricontact::statistics {

namespace {

// Of eigenvalues of the information, over the largest.
constexpr double least_information = 1e-9;
// Share of a direction of which nothing is told that leaves a parameter told.
constexpr double untold_share = 1e-3;

using DenseMatrix = Eigen::MatrixXd;

std::vector<std::vector<double>> rows_of(const DenseMatrix& a) {
    std::vector<std::vector<double>> rows;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        rows.emplace_back();
        for (Eigen::Index j = 0; j < a.cols(); ++j) rows.back().push_back(a(i, j));
    }
    return rows;
}

std::vector<Direction> directions_of(const DenseMatrix& information) {
    const Eigen::SelfAdjointEigenSolver<DenseMatrix> solver(information);
    const auto& values = solver.eigenvalues();
    std::vector<Direction> directions;
    for (Eigen::Index k = values.size() - 1; k >= 0; --k) {  // increasing
        const bool is_told = values[k] > least_information * values[values.size() - 1];
        const Eigen::VectorXd v = solver.eigenvectors().col(k);
        directions.push_back({{v.data(), v.data() + v.size()},
                              is_told ? 1 / std::sqrt(values[k]) : contact::infinity});
    }
    return directions;
}

DenseMatrix pseudo_inverse(const std::vector<Direction>& directions) {
    const auto m = static_cast<Eigen::Index>(directions.size());
    DenseMatrix inverse = DenseMatrix::Zero(m, m);
    for (const Direction& d : directions) {
        if (std::isinf(d.standard_error)) continue;
        const Eigen::Map<const Eigen::VectorXd> v(d.components.data(), m);
        inverse += d.standard_error * d.standard_error * v * v.transpose();
    }
    return inverse;
}

}  // namespace

JointCovariance joint_covariance(const std::vector<std::vector<double>>& columns,
                                 const std::vector<ErrorGroup>& groups) {
    const auto m = static_cast<Eigen::Index>(columns.size());
    const auto n = static_cast<Eigen::Index>(columns.front().size());
    DenseMatrix j(n, m);
    for (Eigen::Index k = 0; k < m; ++k)
        j.col(k) = Eigen::Map<const Eigen::VectorXd>(columns[k].data(), n);
    JointCovariance result;
    const DenseMatrix information = j.transpose() * j;
    result.information = rows_of(information);
    result.principal = directions_of(information);
    const DenseMatrix covariance = pseudo_inverse(result.principal);
    result.covariance = rows_of(covariance);
    for (Eigen::Index k = 0; k < m; ++k) {
        const bool is_told = std::ranges::all_of(result.principal, [&](const Direction& d) {
            return std::isfinite(d.standard_error) || std::abs(d.components[k]) < untold_share;
        });
        result.standard_errors.push_back(is_told ? std::sqrt(covariance(k, k)) : contact::infinity);
    }
    std::vector<double> spread(m, 0.);  // Satterthwaite's denominator
    Eigen::Index row = 0;
    for (const ErrorGroup& group : groups) {
        const auto n_rows = static_cast<Eigen::Index>(group.n_rows);
        const DenseMatrix part = j.middleRows(row, n_rows);
        const DenseMatrix contributed = covariance * (part.transpose() * part);
        const double left = static_cast<double>(group.n_rows) - contributed.trace();
        const DenseMatrix variance = contributed * covariance;
        if (!group.is_known)
            for (Eigen::Index k = 0; k < m; ++k)
                spread[k] += variance(k, k) * variance(k, k) / left;
        result.degrees_of_freedom.push_back(left);
        row += n_rows;
    }
    for (Eigen::Index k = 0; k < m; ++k)
        result.effective_degrees.push_back(
            spread[k] > 0 ? covariance(k, k) * covariance(k, k) / spread[k] : contact::infinity);
    return result;
}

std::vector<Direction> principal_directions(const JointCovariance& all,
                                            const std::vector<std::size_t>& among) {
    std::vector<std::size_t> others;
    for (std::size_t k = 0; k < all.information.size(); ++k)
        if (!std::ranges::count(among, k)) others.push_back(k);
    const auto part = [&](const auto& rows, const auto& cols) {
        DenseMatrix block(rows.size(), cols.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t k = 0; k < cols.size(); ++k)
                block(i, k) = all.information[rows[i]][cols[k]];
        return block;
    };
    DenseMatrix information = part(among, among);
    if (!others.empty()) {  // Schur's complement: the others follow
        const DenseMatrix mixed = part(among, others);
        information -=
            mixed * pseudo_inverse(directions_of(part(others, others))) * mixed.transpose();
    }
    return directions_of(information);
}

}  // namespace tricontact::statistics
