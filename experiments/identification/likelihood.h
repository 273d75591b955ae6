#pragma once

#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// How likely a fit makes the tables, for comparisons of fits to the same ones.
struct Likelihood {
    int n_fitted = 0;          ///< parameters, and errors of tables
    double minus_two_log = 0;  ///< -2 ln L, but for a constant
    /// Akaike's criterion for few observations (Hurvich and Tsai 1989), -2 ln L + 2 k n/(n - k -
    /// 1); infinite without the rows for it.
    double aicc = 0;
};
Likelihood likelihood_of(const IdentificationInput& input, const Identification& found);

/// That noise alone makes -2 ln L so much less by `n_more` parameters of the wider fit: of chi^2,
/// or of F where errors are estimated.
double chance_of_ratio(double ratio, double n_more, const IdentificationInput& input,
                       const Identification& wider);

}  // namespace tricontact::experiments
