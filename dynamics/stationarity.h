#pragma once

#include <cstddef>
#include <span>

namespace tricontact::dynamics {

/// How many values to leave out at the beginning so that the mean of the rest has the least error:
/// marginal standard error rule (MSER), White (1997), Simulation 69. At most half of them; a rule
/// that would leave out half has not found the end of the transient.
std::size_t transient_values(std::span<const double> values);

/// Whether the first and the last third of the values have the same mean within their intervals,
/// after Geweke (1992): they differ by less than 1.5 times the 95 % interval of their difference,
/// which chance exceeds 3 times in 1000. What lies between would blur a change in the middle. False
/// for fewer than six values.
bool stationary(std::span<const double> values);

}  // namespace tricontact::dynamics
