#pragma once

#include "contact/substrates/relaxation.h"

namespace tricontact::theory {

// A rigid cylinder that rolls freely over a half-space of a standard solid, without friction or
// coupling. Hunter (1961), J. Appl. Mech. 28, 611; Johnson (1985), Contact Mechanics, section
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

/// Steady rolling of h = x^2/(2 R) over springs side by side (Winkler's foundation) that relax, of
/// which each springs back for itself; Johnson (1985), Contact Mechanics, section 9.4. With the
/// leading edge at a, lambda_i = v tau_i,
///   p = k/R {(a^2 - x^2)/2 + sum g_i lambda_i [x + lambda_i - (a + lambda_i) exp((x -
///   a)/lambda_i)]}
/// down to the trailing edge, where it vanishes.
struct FoundationRolling {
    contact::Relaxation relaxation;
    double speed;      ///< v [m/s], > 0
    double stiffness;  ///< k, relaxed, pressure over deflection [Pa/m]; or force per length
    double radius;     ///< R [m]
};

struct FoundationContact {
    double leading_edge;   ///< a, from the body's lowest point [m]
    double trailing_edge;  ///< between -a and a [m]
    double force;          ///< ∫ p dx [N/m], of stiffnesses per length [N]
    double lead;  ///< moment of p over the force [m]; the resistance is lead/R of the force
};

/// With this leading edge [m] > 0. Throws std::domain_error for values out of range.
FoundationContact foundation_contact(const FoundationRolling& rolling, double leading_edge);
/// Under this force > 0, see FoundationContact::force.
FoundationContact foundation_contact_under(const FoundationRolling& rolling, double force);

/// The springs of the method of dimensionality reduction under a paraboloid of the radius R [m],
/// whose plane profile is x^2/R: E* [Pa] relaxed; forces are those of three dimensions [N].
FoundationRolling mdr_foundation(const contact::Relaxation& relaxation, double speed,
                                 double effective_modulus, double radius);

/// Rolling resistance over normal force [-] of a body x^2/(2 R) + f(y) that rolls slowly along x
/// over any substrate whose stiffness K relaxes as one, to the first order in the speed v [m/s]:
///   sum g_i v tau_i/R.
/// Slow relaxation is a viscosity beside the spring, K (u + T du/dt), T = sum g_i tau_i; it
/// dissipates v^2 T ∫ du/dx K du/dx dA = v^2 T ∫ du/dx dp/dx dA = v^2 T ∫ p/R dA, by parts: u'' is
/// -1/R where p is not zero. Of a sphere: Brilliantov and Poeschel (1998), Europhys. Lett. 42, 511.
inline double slow_resistance_ratio(const contact::Relaxation& relaxation, double speed,
                                    double radius) {
    double way = 0;
    for (const auto& [ratio, time] : relaxation.branches) way += ratio * time * speed;
    return way / radius;
}

}  // namespace tricontact::theory
