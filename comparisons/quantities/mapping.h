#pragma once

#include <optional>

namespace tricontact::comparisons {

/// kappa carries the error of f_T divided by w u; below this product only noise is left of it.
inline constexpr double least_mapping_product = 1e-5;

/// Mapping parameter kappa of f = 1 - kappa w u - (1 - u)^(3/2) (Wetter (2016), 3.2.16). Empty
/// unless 0 <= w, f, u <= 1 and w u > least_mapping_product.
std::optional<double> mapping_parameter(double w, double f, double u);

/// Ratcheting slope eta = Du/(w - w_lim) (Wetter (2016), 3.3.1); empty unless w > w_lim.
std::optional<double> ratcheting_slope(double increment_ratio, double w, double w_lim);

}  // namespace tricontact::comparisons
