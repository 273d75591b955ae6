#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tricontact::dynamics {

/// Variance of the values in windows of `length` >= 1 of them, one for each place of the window.
/// Wetter (2016), eqs. 4.3.1 and 4.3.2, with the deviations squared: as printed they are not, and
/// their sum would be zero. Empty where the window is longer than the values.
std::vector<double> running_variance(std::span<const double> values, std::size_t length);

/// Share of the windows whose variance exceeds the threshold: Wetter's time of instability, t_is/T.
/// NaN for none.
double share_above(std::span<const double> variances, double threshold);

}  // namespace tricontact::dynamics
