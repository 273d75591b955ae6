#pragma once

#include <functional>

#include "theory/adhesive/adhesive_curve.h"

namespace tricontact::theory {

/// A tension sigma_0 up to the gap delta, nothing beyond (Dugdale 1960): it acts within the radius
/// c, in contact of the radius a <= c and beside it.
struct DugdaleTension {
    double strength;  ///< sigma_0 [Pa]
    double distance;  ///< delta [m]
};

/// Contacts of a rigid body of revolution with a half-space that attract each other like that:
/// Maugis' (1992) solution of the paraboloid for any plane profile g (g(0) = 0) by the springs of
/// the method of dimensionality reduction, exact. The tension stretches them by
///   q(x) = -2 sigma_0 (c^2 - x^2)^(1/2),   a < x < c,
/// q is continuous at a, E* (d - g(a)) = q(a), and the gap at c is delta:
///   delta = 2/pi int_a^c (g - d + q/E*) (c^2 - x^2)^(-1/2) dx.
/// Where they attract each other and do not touch, a is 0 and d follows from the gap.
/// The place along the branch is c + a, which grows all along it.
AdhesiveCurve::Branch dugdale_contacts(AdhesiveCurve::Family family,
                                       std::function<double(double)> profile, double modulus,
                                       const DugdaleTension& tension);

}  // namespace tricontact::theory
