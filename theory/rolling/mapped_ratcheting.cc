#include "theory/rolling/mapped_ratcheting.h"

#include <cmath>
#include <stdexcept>

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

}  // namespace tricontact::theory
