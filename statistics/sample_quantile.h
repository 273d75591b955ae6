#pragma once

#include <vector>

namespace tricontact::statistics {

/// The value that this part of the values, in [0, 1], does not exceed, one of them: the
/// 1 + probability (n - 1) smallest one, rounded down. At least one value.
double sample_quantile(std::vector<double> values, double probability);

}  // namespace tricontact::statistics
