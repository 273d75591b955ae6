#pragma once

#include <vector>

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

}  // namespace tricontact::walking
