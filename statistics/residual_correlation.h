#pragma once

#include <cstddef>
#include <vector>

namespace tricontact::statistics {

/// What a fit by least squares takes from the errors of its rows: residuals are (1 - Q Q^T) of
/// them.
class ResidualProjection {
  public:
    /// `columns`: slopes of all rows' residuals over their errors by each parameter, and what else
    /// was fitted. Of dependent columns one counts.
    explicit ResidualProjection(const std::vector<std::vector<double>>& columns);

    /// An orthonormal basis of the columns: one vector of all rows each.
    const std::vector<std::vector<double>>& basis() const { return basis_; }

  private:
    std::vector<std::vector<double>> basis_;
};

/// What residuals of some rows, in their order, say of the correlation of neighbouring errors, as
/// that of errors whose correlation is rho^|i - k| beside independent ones of all other rows. What
/// the fit takes out of the errors - smooth curves, above all - is accounted for: of independent
/// ones it leaves residuals that alternate.
struct ResidualCorrelation {
    double lag_one = 0;  ///< sum of r_i r_(i+1) over sum of r_i^2
    double chance = 1;   ///< that independent errors leave as much, or more
    /// rho of the errors that leave as much on the average; 0 if that is negative.
    double of_errors = 0;
    /// The largest rho that leaves as little in one of twenty cases, or more often.
    double not_excluded = 0;
};

/// rho of errors is looked for from 0 up to this.
inline constexpr double largest_correlation = .95;

/// `rows`: numbers of the rows in the order in which neighbours may be alike, three at least.
/// Chances are those of up to 2000 draws of a generator with a seed of its own: the same for the
/// same rows.
ResidualCorrelation residual_correlation(const std::vector<double>& residuals,
                                         const std::vector<std::size_t>& rows,
                                         const ResidualProjection& projection);

/// What errors with the correlation rho^|i - k| leave in the sum of squared residuals of the rows,
/// of errors of variance 1.
double mean_sum_of_squares(const std::vector<std::size_t>& rows,
                           const ResidualProjection& projection, double rho);

/// sum over i, k of x_i rho^|i - k| y_k.
double correlated_product(const std::vector<double>& x, const std::vector<double>& y, double rho);

}  // namespace tricontact::statistics
