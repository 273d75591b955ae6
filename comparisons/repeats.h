#pragma once

#include <vector>

#include "comparisons/regression.h"

namespace tricontact::comparisons {

/// Arithmetic mean of repeated measurements, standard error s/sqrt(n), interval by Student's t
/// (thesis A.1.1-A.1.3; DIN 1319-3). Throws std::invalid_argument for fewer than two values.
Estimate mean_of(const std::vector<double>& values, double confidence);

/// Intervals of both exclude each other: only then is it said that they differ.
bool differ(const Estimate& a, const Estimate& b);

}  // namespace tricontact::comparisons
