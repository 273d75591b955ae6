#include "statistics/variance_sizes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "statistics/variance_parts.h"

namespace tricontact::statistics {

std::vector<double> VarianceSum::of(const std::vector<double>& sizes) const {
    std::vector<double> all = fixed;
    for (std::size_t c = 0; c < parts.size(); ++c)
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += sizes[c] * parts[c][i];
    return all;
}

namespace {

using Eigen::MatrixXd, Eigen::VectorXd, Eigen::Index;

constexpr int most_scorings = 200;
constexpr double same_size = 1e-7;
// Two parts that do the same share what they do.
constexpr double parts_ridge = 1e-9;

/// Over the errors of the rows.
VarianceParts::Columns over(VarianceParts::Columns columns, const std::vector<double>& variances) {
    for (auto& column : columns)
        for (std::size_t i = 0; i < column.size(); ++i) column[i] /= std::sqrt(variances[i]);
    return columns;
}

/// Of sizes that are free: by what they change, the others stay.
VectorXd scored(const MatrixXd& traces, const VectorXd& gradient, const std::vector<char>& held) {
    MatrixXd system = traces;
    VectorXd right = gradient;
    system.diagonal() *= 1 + parts_ridge;
    for (Index c = 0; c < right.size(); ++c)
        if (held[c]) {
            system.row(c).setZero();
            system.col(c).setZero();
            system(c, c) = 1;
            right[c] = 0;
        }
    return system.ldlt().solve(right);
}

}  // namespace

std::vector<double> variance_sizes(const std::vector<std::vector<double>>& columns,
                                   const std::vector<std::vector<double>>& own,
                                   const std::vector<double>& residuals, const VarianceSum& sum,
                                   std::vector<double> sizes) {
    const std::size_t n = sizes.size();
    for (int k = 0; k < most_scorings; ++k) {
        const auto variances = sum.of(sizes);
        VarianceParts::Columns shares = sum.parts;  // of the rows' variances by sizes of 1
        for (auto& share : shares)
            for (std::size_t i = 0; i < share.size(); ++i) share[i] /= variances[i];
        const VarianceParts at(over(columns, variances), over(own, variances), shares);
        const VectorXd gradient = at.squares(over({residuals}, variances).front()) - at.expected();
        std::vector<char> held(n);
        for (std::size_t c = 0; c < n; ++c)
            held[c] = !(at.expected()[static_cast<Index>(c)] > 0) ||
                      (sizes[c] <= sum.least[c] && gradient[static_cast<Index>(c)] <= 0);
        VectorXd step = scored(at.traces(), gradient, held);
        double change = 0;
        std::vector<double> to = sizes;
        for (std::size_t round = 0; round < n; ++round) {
            bool all_inside = true;
            for (std::size_t c = 0; c < n; ++c) {
                to[c] = sizes[c] + step[static_cast<Index>(c)];
                if (held[c] || to[c] >= sum.least[c]) continue;
                held[c] = true;
                all_inside = false;
            }
            if (all_inside) break;
            VectorXd right = gradient;
            for (std::size_t c = 0; c < n; ++c)
                if (held[c])
                    right -= at.traces().col(static_cast<Index>(c)) * (sum.least[c] - sizes[c]);
            step = scored(at.traces(), right, held);
            for (std::size_t c = 0; c < n; ++c)
                if (held[c]) step[static_cast<Index>(c)] = sum.least[c] - sizes[c];
        }
        for (std::size_t c = 0; c < n; ++c) {
            to[c] = std::max(sum.least[c], sizes[c] + step[static_cast<Index>(c)]);
            for (std::size_t i = 0; i < variances.size(); ++i)
                change = std::max(change, std::abs(to[c] - sizes[c]) * shares[c][i]);
        }
        sizes = to;
        if (change < same_size) return sizes;
    }
    throw contact::NotConverged(
        "the errors of the rows cannot be estimated from their residuals; state them");
}

}  // namespace tricontact::statistics
