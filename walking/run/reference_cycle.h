#pragma once

#include <vector>

#include "walking/machine/event_driven.h"

namespace tricontact::walking {

/// From one flight of the body to the next: a period of a limit cycle on which it flies once.
struct ReferenceCycle {
    Motion start = {};                     ///< the last spot lifts off
    double period = 0;                     ///< [sqrt(m/k_x)]
    double spring_force = 0;               ///< mean f_s, in units of k_x b
    std::vector<double> stick_times = {};  ///< shares of the period, in the order of spots_of
    double z_min = 0;                      ///< in units of b
    EnergyBalance balance = {};
};

/// Follows a run up to its next flight and from there to the one after that. Throws
/// contact::NotConverged if the body does not fly within 1000 units of time.
ReferenceCycle reference_cycle(EventDriven& run);

}  // namespace tricontact::walking
