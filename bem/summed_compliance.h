#pragma once

#include "contact/substrates/partly_relaxing_substrate.h"

namespace tricontact::bem {

/// Weighted sums of compliances on one grid by the sums of their influence coefficients; empty
/// unless all of them have some (GridCompliance).
contact::PartlyRelaxingSubstrate::Sum sum_of(const contact::CombinedCompliance::Parts& parts,
                                             int n_threads);

}  // namespace tricontact::bem
