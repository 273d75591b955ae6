#include "theory/rolling/mapped_ratcheting.h"

#include <cmath>
#include <stdexcept>

#include "theory/arguments.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::theory {

double half_space_ratcheting_slope(const MappedRolling& p) {
    check(p);
    const double w = p.amplitude_ratio, w_lim = amplitude_limit(p.tangential_ratio);
    if (!(w > w_lim))
        throw std::domain_error("mapped rolling: f must lie above the limit of shakedown");
    const double stick = std::cbrt(1 - p.tangential_ratio), share = w_lim / w;
    const double o = p.poisson / (2 - p.poisson) * std::cos(2 * p.angle);
    return 4 * (1 - stick) * (1 - o / 2 - o * o / 8) /
           (.98 - .964 * w_lim + 1.4 * std::exp(-8.8 * w) * share * share);
}

double half_space_shift_increment_ratio(const MappedRolling& p) {
    check(p);
    const double excess = p.amplitude_ratio - amplitude_limit(p.tangential_ratio);
    return excess > 0 ? half_space_ratcheting_slope(p) * excess : 0;
}

double line_ratcheting_slope(double w, double f) {
    check_unit_interval("ratcheting of a cylinder", "w = W/a", w);
    const double w_lim = line_amplitude_limit(f);
    if (!(w > w_lim))
        throw std::domain_error("ratcheting of a cylinder: f must lie above the limit");
    return line_steady_slope(f, 1) /
           (1 - 1.02 * std::pow(w_lim, 1.44) + 1.55 * std::exp(-8.3 * w) * std::pow(w_lim / w, 3));
}

double line_shift_increment_ratio(double w, double f, double lambda) {
    const double excess = w - line_amplitude_limit(f);
    return excess > 0 ? line_ratcheting_slope(w, f) * excess / lambda : 0;
}

}  // namespace tricontact::theory
