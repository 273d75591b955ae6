#pragma once

#include <optional>
#include <vector>

#include "comparisons/fitted_form.h"
#include "comparisons/numerical_bar.h"

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

/// Largest w that settles at f_T in [0, 1], the inverse of a model's own limit: k of the form above
/// is interpolated linearly between the amplitudes and constant beyond them, so that what is
/// interpolated is almost constant. Bar: that of the nearest limit, and what leaving it out would
/// change; unknown with one amplitude. Empty without any limit at 0 < w < 1.
std::optional<Computed> amplitude_limit(const std::vector<LimitPoint>& limits, double f);

}  // namespace tricontact::comparisons
