#pragma once

#include <span>
#include <vector>

#include "walking/machine/machine.h"

namespace tricontact::walking {

/// Deflections of the springs of a contact spot, in units of b.
struct SpotDeflection {
    double normal = 0;      ///< n >= 0; 0: released
    double tangential = 0;  ///< u, along the motion
    double flank = 0;       ///< u_s, along the flank of a prism; else 0

    bool operator==(const SpotDeflection&) const = default;
};

/// State of a machine; lengths in units of b, times of sqrt(m/k_x). x forwards, z downwards,
/// phi = (a/b) Phi counter-clockwise.
struct Motion {
    double time = 0;
    double base = 0;  ///< x_s, of the spring's base
    double x = 0, z = 0, phi = 0;
    double x_velocity = 0, z_velocity = 0, phi_velocity = 0;
    std::vector<SpotDeflection> spots = {};  ///< in the order of springs_of

    bool operator==(const Motion&) const = default;
};

/// What a contact spot does; the numbers are those of contact_state in files for ParaView.
enum class SpotState { released = 0, stick = 1, slip = 2 };

/// The machine at one time, for pictures.
struct Snapshot {
    Motion motion;
    std::vector<SpotState> spots;  ///< in the order of spots_of
};

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

/// On the line from a to b, `share` of the way.
Motion between(const Motion& a, const Motion& b, double share);

/// n of a spring where the body now is: normal to the ground, or to a flank of the prism.
double normal_deflection(const Machine& machine, const Spot& spring, const Motion& motion);

/// Where a run begins. Displacements in units of the static displacement, velocities in units of
/// that of the base (kappa6); the springs of the spots have no tangential deflection.
struct Start {
    double x = 0, z = 1, phi = 0, base = 0;
    double x_velocity = 0, z_velocity = 0, phi_velocity = 0;

    bool operator==(const Start&) const = default;
};

/// Motion at the start; by default at rest on the ground: Wetter (2016), eq. 4.1.21.
Motion motion_at_start(const Machine& machine, const Start& start = {});

}  // namespace tricontact::walking
