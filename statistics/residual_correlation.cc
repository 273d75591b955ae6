#include "statistics/residual_correlation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

#include "contact/base/root.h"
#include "statistics/latin_hypercube.h"

namespace tricontact::statistics {

namespace {

using DenseMatrix = Eigen::MatrixXd;
using DenseVector = Eigen::VectorXd;

// Of pivots, over the largest: dependent columns.
constexpr double least_pivot = 1e-9;
constexpr std::uint64_t draws_seed = 42;
// Standard deviation of a chance of .05: .005. Of long tables fewer draws, whose statistic is
// nearly normal.
constexpr std::size_t most_draws = 2000, least_draws = 200, most_numbers = 400'000;
constexpr double excluded_chance = .05;
// Of rho: an order below what any table tells of it.
constexpr int rho_bits = 10;

/// sum over k of rho^|i - k| x_k, by two recursions.
DenseVector row_sums(const DenseVector& x, double rho) {
    DenseVector sums = x;
    double carried = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        sums[i] += carried;
        carried = rho * (carried + x[i]);
    }
    carried = 0;
    for (Eigen::Index i = x.size() - 1; i >= 0; --i) {
        sums[i] += carried;
        carried = rho * (carried + x[i]);
    }
    return sums;
}

/// Half the sum of both neighbours.
DenseVector neighbours(const DenseVector& x) {
    DenseVector sums = DenseVector::Zero(x.size());
    sums.head(x.size() - 1) += x.tail(x.size() - 1) / 2;
    sums.tail(x.size() - 1) += x.head(x.size() - 1) / 2;
    return sums;
}

/// Residuals of some rows and what a fit leaves of their errors.
class FittedRows {
  public:
    FittedRows(const std::vector<std::size_t>& rows, const ResidualProjection& projection)
        : q_(rows.size(), projection.basis().size()) {
        for (Eigen::Index i = 0; i < q_.rows(); ++i)
            for (Eigen::Index k = 0; k < q_.cols(); ++k) q_(i, k) = projection.basis()[k][rows[i]];
        gram_ = q_.transpose() * q_;
        rest_ = DenseMatrix::Identity(q_.cols(), q_.cols()) - gram_;
    }

    /// Means of sum r_i r_(i+1) and of sum r_i^2.
    struct Means {
        double products = 0, squares = 0;
        double lag_one() const { return squares > 0 ? products / squares : 0; }
    };
    Means means(double rho) const {
        // The covariance of the residuals is W - Q P^T - P Q^T + Q G Q^T, W = rho^|i - k|, P = W Q,
        // G = Q^T P of these rows and what the others, independent, add.
        DenseMatrix p(q_.rows(), q_.cols()), beside(q_.rows(), q_.cols());
        for (Eigen::Index k = 0; k < q_.cols(); ++k) {
            p.col(k) = row_sums(q_.col(k), rho);
            beside.col(k) = neighbours(q_.col(k));
        }
        const DenseMatrix g = q_.transpose() * p + rest_;
        const auto n = static_cast<double>(q_.rows());
        return {(n - 1) * rho - 2 * beside.cwiseProduct(p).sum() +
                    (g * (q_.transpose() * beside)).trace(),
                n - 2 * q_.cwiseProduct(p).sum() + (g * gram_).trace()};
    }

    Eigen::Index n() const { return q_.rows(); }
    const DenseMatrix& basis() const { return q_; }
    const DenseMatrix& rest() const { return rest_; }

  private:
    DenseMatrix q_, gram_, rest_;
};

double lag_one(const DenseVector& residuals) {
    const auto n = residuals.size() - 1;
    const double squares = residuals.squaredNorm();
    return squares > 0 ? residuals.head(n).dot(residuals.tail(n)) / squares : 0;
}

/// Independent errors of mean 0 and standard deviation 1, the same for every rho.
class Draws {
  public:
    explicit Draws(const FittedRows& rows) : rows_(rows) {
        const auto n = static_cast<std::size_t>(rows.n());
        const std::size_t n_draws = std::clamp(most_numbers / n, least_draws, most_draws);
        if (rows.rest().size() > 0) {  // else nothing was fitted that moves a residual
            const Eigen::SelfAdjointEigenSolver<DenseMatrix> solver(rows.rest());
            root_ =
                solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
        }
        SplitMix64 random(draws_seed);
        errors_.resize(rows.n(), static_cast<Eigen::Index>(n_draws));
        of_others_.resize(root_.cols(), errors_.cols());
        for (DenseMatrix* drawn : {&errors_, &of_others_})
            for (double& value : drawn->reshaped()) value = normal(random);
    }

    /// How often errors of this correlation leave `observed` or more.
    double chance(double rho, double observed) const {
        Eigen::Index n_above = 0;
        const double fresh = std::sqrt(1 - rho * rho);
        for (Eigen::Index draw = 0; draw < errors_.cols(); ++draw) {
            DenseVector e = errors_.col(draw);
            for (Eigen::Index i = 1; i < e.size(); ++i) e[i] = rho * e[i - 1] + fresh * e[i];
            const DenseVector taken = rows_.basis().transpose() * e + root_ * of_others_.col(draw);
            e -= rows_.basis() * taken;
            n_above += lag_one(e) >= observed;
        }
        return static_cast<double>(n_above) / static_cast<double>(errors_.cols());
    }

  private:
    /// Box and Muller (1958).
    static double normal(SplitMix64& random) {
        const double radius = std::sqrt(-2 * std::log1p(-random.uniform()));
        return radius * std::cos(2 * std::numbers::pi * random.uniform());
    }

    const FittedRows& rows_;
    DenseMatrix errors_, of_others_, root_;
};

}  // namespace

ResidualProjection::ResidualProjection(const std::vector<std::vector<double>>& columns) {
    const auto n = static_cast<Eigen::Index>(columns.front().size());
    DenseMatrix j(n, columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Eigen::Map<const DenseVector> column(columns[k].data(), n);
        const double size = column.norm();
        j.col(static_cast<Eigen::Index>(k)) = column / (size > 0 ? size : 1);
    }
    Eigen::ColPivHouseholderQR<DenseMatrix> qr(j);
    qr.setThreshold(least_pivot);
    const DenseMatrix q = qr.householderQ() * DenseMatrix::Identity(n, qr.rank());
    for (Eigen::Index k = 0; k < q.cols(); ++k)
        basis_.emplace_back(q.col(k).data(), q.col(k).data() + n);
}

ResidualCorrelation residual_correlation(const std::vector<double>& residuals,
                                         const std::vector<std::size_t>& rows,
                                         const ResidualProjection& projection) {
    if (rows.size() < 3) throw std::invalid_argument("three residuals at least have a pattern");
    DenseVector r(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) r[i] = residuals[rows[i]];
    const FittedRows of_fit(rows, projection);
    const Draws draws(of_fit);
    ResidualCorrelation result;
    result.lag_one = lag_one(r);
    result.chance = draws.chance(0, result.lag_one);
    const auto largest_of = [](const auto& exceeds) {
        if (exceeds(0) >= 0) return 0.;
        if (exceeds(largest_correlation) <= 0) return largest_correlation;
        return contact::bracketed_root(exceeds, 0., largest_correlation, rho_bits);
    };
    result.of_errors =
        largest_of([&](double rho) { return of_fit.means(rho).lag_one() - result.lag_one; });
    result.not_excluded = largest_of(
        [&](double rho) { return draws.chance(rho, result.lag_one) - (1 - excluded_chance); });
    return result;
}

double mean_sum_of_squares(const std::vector<std::size_t>& rows,
                           const ResidualProjection& projection, double rho) {
    return FittedRows(rows, projection).means(rho).squares;
}

double correlated_product(const std::vector<double>& x, const std::vector<double>& y, double rho) {
    const auto n = static_cast<Eigen::Index>(x.size());
    const Eigen::Map<const DenseVector> left(x.data(), n), right(y.data(), n);
    return left.dot(row_sums(right, rho));
}

}  // namespace tricontact::statistics
