#include "statistics/outlying_rows.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <optional>

namespace tricontact::statistics {

namespace {

// Of eigenvalues of the information, over the largest: what differences resolve.
constexpr double least_share_told = 1e-9;
// A mean square of residuals over estimated errors is 1, unless these are the least that is taken.
constexpr double least_mean_square = .5;
// The share of a row that it does not tell itself: below it a row has no residual.
constexpr double least_share_left = 1e-6;
constexpr double least_degrees = 1;

/// A fit without some of its rows.
class PartialFit {
  public:
    PartialFit(const std::vector<double>& residuals,
               const std::vector<std::vector<double>>& columns,
               const std::vector<ErrorGroup>& groups)
        : slopes_(residuals.size(), columns.size()),
          residuals_(Eigen::Map<const Eigen::VectorXd>(residuals.data(), slopes_.rows())),
          left_(residuals.size(), true),
          groups_(groups) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            slopes_.col(static_cast<Eigen::Index>(k)) =
                Eigen::Map<const Eigen::VectorXd>(columns[k].data(), slopes_.rows());
        fit();
    }

    /// The farthest row that is left.
    std::optional<OutlyingRow> farthest() const {
        std::optional<OutlyingRow> found;
        Eigen::Index row = 0;
        for (const ErrorGroup& group : groups_) {
            const auto end = row + static_cast<Eigen::Index>(group.n_rows);
            const double squares = now_.segment(row, end - row).squaredNorm();
            const double degrees = degrees_of(group, row, end);
            const bool is_fitted_to_rounding =
                !group.is_known && squares < least_mean_square * degrees;
            for (; row < end; ++row) {
                if (!left_[row] || is_fitted_to_rounding) continue;
                const double share = share_left(row);
                if (share < least_share_left) continue;
                OutlyingRow one{.row = static_cast<std::size_t>(row)};
                const double squared = now_[row] * now_[row] / share;
                if (group.is_known) {
                    one.deviation = std::sqrt(squared);
                    one.chance = tail(boost::math::normal(), one.deviation);
                } else {
                    if (degrees <= least_degrees) continue;
                    const double others =
                        squares_without(row, end - static_cast<Eigen::Index>(group.n_rows), end) /
                        (degrees - 1);
                    one.deviation = std::sqrt(squared / std::max(others, 1e-12 * squares));
                    one.chance = tail(boost::math::students_t(degrees - 1), one.deviation);
                }
                one.deviation = std::copysign(one.deviation, now_[row]);
                if (!found || one.chance < found->chance) found = one;
            }
        }
        if (found) found->chance = std::min(1., found->chance * static_cast<double>(n_left()));
        return found;
    }

    void leave_out(OutlyingRow& one) {
        left_[one.row] = false;
        fit();
        one.change.assign(change_.data(), change_.data() + change_.size());
    }

  private:
    /// Two-sided.
    template <typename D>
    static double tail(const D& distribution, double deviation) {
        return 2 * boost::math::cdf(boost::math::complement(distribution, deviation));
    }

    std::ptrdiff_t n_left() const { return std::count(left_.begin(), left_.end(), true); }

    /// Squares of a group's other rows where the fit is without this one, which rows of other
    /// groups may hold in place.
    double squares_without(Eigen::Index row, Eigen::Index first, Eigen::Index end) const {
        const Eigen::VectorXd change =
            covariance_ * slopes_.row(row).transpose() * (now_[row] / share_left(row));
        double squares = 0;
        for (Eigen::Index other = first; other < end; ++other)
            if (other != row && left_[other])
                squares += std::pow(now_[other] + slopes_.row(other).dot(change), 2);
        return squares;
    }

    /// What a row does not tell of itself.
    double share_left(Eigen::Index row) const {
        return 1 - slopes_.row(row) * covariance_ * slopes_.row(row).transpose();
    }

    /// Rows that are left in a group, less the share of the variables that they tell.
    double degrees_of(const ErrorGroup& group, Eigen::Index first, Eigen::Index end) const {
        double degrees = -static_cast<double>(group.n_own);
        for (Eigen::Index row = first; row < end; ++row)
            if (left_[row]) degrees += share_left(row);
        return degrees;
    }

    /// By the rows that are left, from the slopes at the fit to all of them.
    void fit() {
        Eigen::MatrixXd information = Eigen::MatrixXd::Zero(slopes_.cols(), slopes_.cols());
        Eigen::VectorXd downhill = Eigen::VectorXd::Zero(slopes_.cols());
        for (Eigen::Index row = 0; row < slopes_.rows(); ++row) {
            if (!left_[row]) continue;
            information += slopes_.row(row).transpose() * slopes_.row(row);
            downhill -= slopes_.row(row).transpose() * residuals_[row];
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(information);
        Eigen::VectorXd inverse = solver.eigenvalues();
        const double least = least_share_told * inverse.maxCoeff();
        for (double& value : inverse) value = value > least ? 1 / value : 0;
        covariance_ =
            solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
        change_ = covariance_ * downhill;
        now_ = residuals_ + slopes_ * change_;
        for (Eigen::Index row = 0; row < now_.size(); ++row)
            if (!left_[row]) now_[row] = 0;
    }

    Eigen::MatrixXd slopes_, covariance_;
    Eigen::VectorXd residuals_, now_, change_;
    std::vector<bool> left_;
    const std::vector<ErrorGroup>& groups_;
};

}  // namespace

std::vector<OutlyingRow> outlying_rows(const std::vector<double>& residuals,
                                       const std::vector<std::vector<double>>& columns,
                                       const std::vector<ErrorGroup>& groups, double chance) {
    PartialFit fit(residuals, columns, groups);
    std::vector<OutlyingRow> rows;
    while (rows.size() < most_outlying) {
        std::optional<OutlyingRow> next = fit.farthest();
        if (!next || next->chance >= chance) break;
        fit.leave_out(*next);
        rows.push_back(std::move(*next));
    }
    return rows;
}

}  // namespace tricontact::statistics
