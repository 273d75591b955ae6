#pragma once

#include "contact/substrates/relaxation.h"

namespace tricontact::theory {

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

}  // namespace tricontact::theory
