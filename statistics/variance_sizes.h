#pragma once

#include <vector>

namespace tricontact::statistics {

/// Sizes of variances that add up in rows: of row i, fixed_i + sum over c of size_c parts_ci.
struct VarianceSum {
    std::vector<double> fixed;               ///< of each row
    std::vector<std::vector<double>> parts;  ///< of size 1, a column per part
    std::vector<double> least;               ///< of each size
    /// Of each row, with these sizes.
    std::vector<double> of(const std::vector<double>& sizes) const;
};

/// Restricted maximum likelihood by Fisher's scoring within the bounds. `columns`, `own`:
/// slopes as of VarianceParts, which are not over any error here, nor are the residuals. Throws
/// contact::NotConverged.
std::vector<double> variance_sizes(const std::vector<std::vector<double>>& columns,
                                   const std::vector<std::vector<double>>& own,
                                   const std::vector<double>& residuals, const VarianceSum& sum,
                                   std::vector<double> start);

}  // namespace tricontact::statistics
