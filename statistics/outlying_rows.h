#pragma once

#include <cstddef>
#include <vector>

#include "statistics/joint_covariance.h"

namespace tricontact::statistics {

/// A row that is not where the other ones put it.
struct OutlyingRow {
    std::size_t row = 0;
    double deviation = 0;  ///< from there, over the standard error of such a prediction
    /// That normal errors take any of the rows as far, or farther.
    double chance = 1;
    /// Of the fit's variables by leaving out this row and those named before it, to first order.
    std::vector<double> change = {};
};

/// Rows of a fit by least squares whose `chance` is below this, the farthest first; at most
/// `most_outlying` of them, each looked for without those before it. The deviation is the residual
/// over its standard error, of groups with estimated errors by those of the other rows
/// (externally studentised; Beckman and Cook 1983, Technometrics 25, 119), the chance that of the
/// largest by Bonferroni's inequality. `residuals` over the errors, `columns` their slopes by each
/// variable, `groups` as in joint_covariance(). Groups that are fitted to rounding have none.
std::vector<OutlyingRow> outlying_rows(const std::vector<double>& residuals,
                                       const std::vector<std::vector<double>>& columns,
                                       const std::vector<ErrorGroup>& groups, double chance);

inline constexpr std::size_t most_outlying = 3;

}  // namespace tricontact::statistics
