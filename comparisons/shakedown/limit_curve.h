#pragma once

#include <optional>
#include <vector>

#include "comparisons/resolution/numerical_bar.h"
#include "comparisons/shakedown/fitted_form.h"

namespace tricontact::comparisons {

/// Shakedown limit of a model at one amplitude, from its own pressures.
struct LimitPoint {
    double amplitude_ratio = 0;  ///< w
    Computed limit;              ///< f_T,lim
};

/// One number k for f_T,lim = 1 - k w (1 - w^2) - w^3, which has the ends right whatever the
/// pressures: k = 3/2 for Hertz' (exact, see theory::shakedown_limit, which ends there), else a
/// fit. Empty below two points.
std::optional<FittedForm> fit_limit(const std::vector<LimitPoint>& limits, double confidence);

}  // namespace tricontact::comparisons
