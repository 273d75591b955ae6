#pragma once

#include <string_view>

namespace tricontact::statistics {

/// How an uncertain number is spread around its value, symmetrically.
enum class Distribution { normal, uniform, triangular };

std::string_view name_of(Distribution distribution);  ///< "normal", "uniform", "triangular"

/// Standard deviations in what states the spread: the standard deviation itself of a normal
/// distribution, half the width of a bounded one. 1, 1/sqrt(3), 1/sqrt(6): JCGM 100:2008 (GUM),
/// 4.3.7 and 4.3.9.
double standard_deviations(Distribution distribution);

/// The value that is not exceeded with this probability in (0, 1), of mean 0 and standard deviation
/// 1; within [0, 1] for bounded distributions.
double standard_quantile(Distribution distribution, double probability);

}  // namespace tricontact::statistics
