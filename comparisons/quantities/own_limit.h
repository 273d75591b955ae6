#pragma once

#include <optional>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// w_lim = W/a at which the least of a model's pressures, moved to and fro by W along the rolling
/// direction, carry f_T: (1/F_N) ∫ min p(x - s) dA = f_T, the minimum over |s| <= W. The pressures
/// are those of the last upright state, of coupled contact those that friction left. Empty unless 0
/// < f_T < 1, without rolling, under oscillating loads, on periodic surfaces and without snapshots.
/// O(h^2) in the size of the cells.
std::optional<double> own_amplitude_limit(const contact::Case& c, const contact::History& history);

}  // namespace tricontact::comparisons
