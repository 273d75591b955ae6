#pragma once

namespace tricontact::theory {

// A rigid cylinder that rolls freely over a half-space of a standard solid, without friction or
// coupling. Hunter (1961), J. Mech. Phys. Solids 9, 219; Johnson (1985), Contact Mechanics, section
// 9.4. Poisson's ratio is constant in time.

/// What rolls over what.
struct HunterRolling {
    double effective_modulus;  ///< E* of the relaxed half-space [Pa]
    double radius;             ///< R of the cylinder [m]
    double ratio;              ///< g = G2/G1 of the Maxwell element, see contact::Relaxation [-]
    double relaxation_way;     ///< v tau, rolled while the material relaxes [m], > 0
};

/// Contact under a force.
struct HunterContact {
    double half_length;  ///< l [m]
    /// Moment of the pressure about the cylinder's lowest point over its force [m]: the resistance
    /// to rolling is that part of R of the normal force.
    double lead;
};

/// Under the normal force per length [N/m] > 0. Throws std::domain_error for values out of range.
HunterContact hunter_contact(const HunterRolling& rolling, double force_per_length);

}  // namespace tricontact::theory
