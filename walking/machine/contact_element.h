#pragma once

#include <algorithm>
#include <cmath>

#include "walking/machine/motion.h"

namespace tricontact::walking {

/// What a contact spot did in a step.
struct SpotStep {
    bool sticks = false;    ///< in contact, below its friction bound; a released spot does not
    double slip = 0;        ///< increment of slip along the motion: trial minus new deflection
    double flank_slip = 0;  ///< along the flank of a prism
};

/// Spring with a Coulomb slider: a new approach and an increment of tangential displacement. A spot
/// in the air has no deflection, and lands with none. Wetter (2016), eqs. B.4.1 to B.4.4.
/// `bound`: friction bound over tangential stiffness, mu kappa2 times the normal deflection.
inline SpotStep advance_flat(SpotDeflection& spot, double approach, double bound,
                             double tangential_increment) {
    spot.normal = std::max(0., approach);
    const double trial = spot.tangential + tangential_increment;
    spot.tangential = std::clamp(trial, -bound, bound);
    return {.sticks = std::abs(trial) < bound, .slip = trial - spot.tangential};
}

/// The same on a flank: two tangential directions under one bound, radial return. Wetter (2016),
/// eqs. B.4.5 to B.4.9, with the sign of the flank's deflection that follows from its geometry.
/// `approach` and its bound: normal to the flank.
inline SpotStep advance_on_flank(SpotDeflection& spot, double approach, double bound,
                                 double tangential_increment, double flank_increment) {
    spot.normal = std::max(0., approach);
    const double x = spot.tangential + tangential_increment, s = spot.flank + flank_increment;
    const double length = std::hypot(x, s);
    const double factor = length < bound ? 1 : bound / length;
    spot.tangential = length > 0 ? factor * x : 0;
    spot.flank = length > 0 ? factor * s : 0;
    return {.sticks = length < bound, .slip = x - spot.tangential, .flank_slip = s - spot.flank};
}

}  // namespace tricontact::walking
