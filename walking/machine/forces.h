#pragma once

#include <span>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// Forces of one contact spot on the body, in units of k_x b.
struct SpotForce {
    double normal = 0;      ///< upwards, >= 0 on flat ground
    double tangential = 0;  ///< against the motion where positive
};

/// Accelerations x'', z'', phi''.
struct Acceleration {
    double x = 0, z = 0, phi = 0;
};

/// f_s = kappa1 (x_s - x + kappa8 phi), in units of k_x b; positive pulls forwards. Wetter (2016),
/// eq. 4.1.23.
double spring_force(const Machine& machine, const Motion& motion);

/// Forces of a spot or spring with this deflection.
SpotForce spot_force(const Machine& machine, const Spot& spot, const SpotDeflection& deflection);

/// Newton's law for small rotations; Wetter (2016), eqs. 4.1.17 to 4.1.19 and 5.2.23 to 5.2.25, for
/// springs anywhere along the base. `springs`: springs_of(machine).
Acceleration acceleration(const Machine& machine, std::span<const Spot> springs,
                          const Motion& motion);

}  // namespace tricontact::walking
