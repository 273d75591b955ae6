#pragma once

#include <functional>
#include <vector>

#include "statistics/estimate.h"

namespace tricontact::statistics {

/// What a function of uncertain quantities becomes.
struct Propagated {
    Estimate result;
    /// Change of the result when one quantity grows by its standard error, one per quantity.
    std::vector<double> contributions;
};

/// A function of quantities in the order in which they were given.
using Quantity = std::function<double(const std::vector<double>&)>;

/// First-order propagation: variance = sum_ij c_i r_ij c_j with c_i = (df/dx_i) sigma_i;
/// derivatives by central differences. JCGM 100:2008 (GUM), eq. 10 for independent and 16 for
/// correlated quantities. `correlation`: r_ij, a row each; empty: independent. First order:
/// relative errors beyond some 30 % need more. Throws std::invalid_argument for a negative error or
/// other sizes, std::domain_error if the function or its derivative is not finite; and what `f`
/// throws.
Propagated propagate(const Quantity& f, const std::vector<Estimate>& quantities,
                     const std::vector<std::vector<double>>& correlation = {});

}  // namespace tricontact::statistics
