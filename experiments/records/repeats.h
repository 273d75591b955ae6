#pragma once

#include <vector>

#include "statistics/regression.h"

namespace tricontact::experiments {

/// Arithmetic mean of repeated measurements, standard error s/sqrt(n), interval by Student's t
/// (thesis A.1.1-A.1.3; DIN 1319-3). Throws std::invalid_argument for fewer than two values.
statistics::Estimate mean_of(const std::vector<double>& values, double confidence);

/// Intervals of both exclude each other: only then is it said that they differ.
bool differ(const statistics::Estimate& a, const statistics::Estimate& b);

}  // namespace tricontact::experiments
