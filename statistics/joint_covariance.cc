#include "statistics/joint_covariance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "statistics/variance_parts.h"

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

/// Errors of these groups are estimated from the residuals over their rows less the share of the
/// parameters that they tell (restricted maximum likelihood): they and the weights are uncertain
/// themselves. Kenward and Roger (1997, Biometrics 53, 983): adjusted covariance, and degrees of
/// freedom of one parameter. `told`: information of each group.
void add_estimated_errors(const DenseMatrix& covariance, const std::vector<DenseMatrix>& told,
                          const std::vector<double>& n_rows, JointCovariance& result) {
    const auto m = covariance.rows(), n = static_cast<Eigen::Index>(told.size());
    std::vector<DenseMatrix> slopes;  // of the covariance by each squared error, relative
    for (const DenseMatrix& one : told) slopes.push_back(covariance * one * covariance);
    DenseMatrix information(n, n);  // of the squared errors, relative
    for (Eigen::Index g = 0; g < n; ++g) {
        for (Eigen::Index h = 0; h < n; ++h) information(g, h) = (slopes[g] * told[h]).trace() / 2;
        information(g, g) += n_rows[g] / 2 - (covariance * told[g]).trace();
    }
    const DenseMatrix of_errors = information.inverse();
    DenseMatrix added = DenseMatrix::Zero(m, m);
    Eigen::VectorXd spread = Eigen::VectorXd::Zero(m);
    for (Eigen::Index g = 0; g < n; ++g) {
        added += of_errors(g, g) * slopes[g];
        for (Eigen::Index h = 0; h < n; ++h) {
            added -= of_errors(g, h) * slopes[g] * told[h] * covariance;
            spread += of_errors(g, h) * slopes[g].diagonal().cwiseProduct(slopes[h].diagonal());
        }
    }
    result.adjusted = rows_of(covariance + 2 * added);
    for (Eigen::Index k = 0; k < m; ++k)
        result.effective_degrees.push_back(spread[k] > 0
                                               ? 2 * covariance(k, k) * covariance(k, k) / spread[k]
                                               : contact::infinity);
}

// Of a row's variance: a smaller part is none.
constexpr double least_part = 1e-6;

/// The same of variances that are sums of parts.
void add_estimated_parts(const DenseMatrix& covariance, const VarianceParts& parts,
                         JointCovariance& result) {
    const auto m = covariance.rows(), n = parts.traces().rows();
    DenseMatrix information = parts.traces() / 2;
    constexpr double ridge = 1e-9;  // parts that do the same share what they do
    information.diagonal() *= 1 + ridge;
    const DenseMatrix of_errors = information.inverse();
    DenseMatrix added = DenseMatrix::Zero(m, m);
    Eigen::VectorXd spread = Eigen::VectorXd::Zero(m);
    std::vector<Eigen::VectorXd> slopes;
    for (const DenseMatrix& told : parts.told())
        slopes.push_back((covariance * told * covariance).diagonal());
    for (Eigen::Index c = 0; c < n; ++c)
        for (Eigen::Index d = 0; d < n; ++d) {
            added += of_errors(c, d) * covariance * parts.left(c, d) * covariance;
            spread += of_errors(c, d) * slopes[c].cwiseProduct(slopes[d]);
        }
    result.adjusted = rows_of(covariance + 2 * added);
    for (Eigen::Index k = 0; k < m; ++k)
        result.effective_degrees.push_back(spread[k] > 0
                                               ? 2 * covariance(k, k) * covariance(k, k) / spread[k]
                                               : contact::infinity);
}

/// Parts of all groups over all rows.
std::vector<std::vector<double>> all_parts(const std::vector<ErrorGroup>& groups,
                                           std::size_t n_rows) {
    std::vector<std::vector<double>> all;
    std::size_t row = 0;
    for (const ErrorGroup& group : groups) {
        auto parts = group.parts;
        if (parts.empty() && !group.is_known) parts.emplace_back(group.n_rows, 1.);
        for (const auto& part : parts) {
            if (*std::ranges::max_element(part) < least_part) continue;
            auto& column = all.emplace_back(n_rows, 0.);
            std::ranges::copy(part, column.begin() + static_cast<std::ptrdiff_t>(row));
        }
        row += group.n_rows;
    }
    return all;
}

}  // namespace

JointCovariance joint_covariance(const std::vector<std::vector<double>>& columns,
                                 const std::vector<ErrorGroup>& groups,
                                 const std::vector<std::vector<double>>& own) {
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
    std::vector<DenseMatrix> unknown;  // information of groups whose errors are estimated
    std::vector<double> unknown_rows;
    Eigen::Index row = 0;
    for (const ErrorGroup& group : groups) {
        const auto n_rows = static_cast<Eigen::Index>(group.n_rows);
        const DenseMatrix part = j.middleRows(row, n_rows);
        const DenseMatrix told = part.transpose() * part;
        const auto n_told_by = static_cast<double>(group.n_rows - group.n_own);
        result.degrees_of_freedom.push_back(n_told_by - (covariance * told).trace());
        if (!group.is_known) {
            unknown.push_back(told);
            unknown_rows.push_back(n_told_by);
        }
        row += n_rows;
    }
    if (std::ranges::all_of(groups, [](const ErrorGroup& g) { return g.parts.empty(); }))
        add_estimated_errors(covariance, unknown, unknown_rows, result);
    else
        add_estimated_parts(covariance,
                            VarianceParts(columns, own, all_parts(groups, columns.front().size())),
                            result);
    for (Eigen::Index k = 0; k < m; ++k) {
        const bool is_told = std::ranges::all_of(result.principal, [&](const Direction& d) {
            return std::isfinite(d.standard_error) || std::abs(d.components[k]) < untold_share;
        });
        result.standard_errors.push_back(is_told ? std::sqrt(result.adjusted[k][k])
                                                 : contact::infinity);
    }
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
