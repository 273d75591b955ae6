#pragma once

#include <optional>

#include "contact/bodies/indenter.h"
#include "contact/load_path.h"
#include "theory/layer/layer_compliance.h"
#include "theory/line_load.h"

namespace tricontact::theory {

// Frictionless contact of a rigid body of revolution with an elastic layer on a rigid plane, exact
// but for rounding: a Fredholm equation in one dimension, solved by Nyström's method with points
// added until d, F and dF/dd stand still to 1e-10 (see layer_equation.h). Small strains and slopes;
// the body is rigid; the layer sticks to or glides on its base everywhere and does not lift off.
//   E* g_d = E* [d - g(x)] is the right-hand side, g the plane profile of the method of
//   dimensionality reduction, g(x) = |x| ∫_0^|x| h'(r)/sqrt(x^2 - r^2) dr (Popov and Hess 2015,
//   eq. 3.27); the contact radius follows from q(a) = 0 and the force is F = 2 ∫_0^a q dx.
// Range: a/b <= 32 (chi = sqrt(R d)/b up to 16 for a paraboloid), any thicker layer down to the
// half-space (a/b -> 0), every nu in (-1, 1/2], both bases.

inline constexpr double largest_radius_over_thickness = 32;

/// One state of contact, SI units.
struct LayerContact {
    double contact_radius;    ///< a [m]
    double indentation;       ///< d [m]
    double normal_force;      ///< F [N]
    double normal_stiffness;  ///< dF/dd [N/m]: that of a flat punch of radius a
    /// p(0) [Pa], largest for smooth convex bodies (not for a punch); infinite under a conical tip.
    double centre_pressure;
    /// U_max/mu [m]: u_x at the contact centre under the traction p along x. Empty on a
    /// frictionless base, which gives no hold: the integral diverges.
    std::optional<double> unit_shift;
    LineLoad line_load;  ///< q [N/m]

    /// Pressure [Pa] at r >= 0 [m], zero outside; to 1e-10 of the mean pressure, less within a few
    /// percent of a kink or of a conical tip, where it is singular.
    double pressure(double r) const { return line_load.pressure(r); }
};

/// Contact of `indenter` under a given force or indentation, both > 0.
/// Throws contact::InputError for values out of range: a contact that reaches the indenter's rim,
/// a/b above its limit, a profile whose contact is no disc. Throws contact::NotConverged if more
/// points keep changing the result (a profile with undeclared kinks).
LayerContact solve_layer_contact(const ElasticLayer& layer,
                                 const contact::AxisymmetricIndenter& indenter,
                                 const contact::NormalControl& control);

// Limit of shakedown of a contact that rolls back and forth by the amplitude W, at any angle to the
// load, without coupling of normal and tangential contact: the largest F_T/(mu F_N) that points can
// carry whose traction never exceeds their least bound, (1/F_N) ∫ min over the path of mu p dA over
// mu. If p falls with r, the least pressure is that where the path is farthest from the axis, and
//   f_T,lim = 1 - ∫_0^W q dx / ∫_0^a q dx,   q = ∫ p dy the line load:
// of Hertz' contact 1 - 3/2 w + 1/2 w^3, w = W/a. Pressures under paraboloid and sphere fall with r
// on any layer.

/// f_T,lim at w = W/a in [0, 1]. Throws std::domain_error for other w.
double shakedown_limit(const LayerContact& contact, double w);

/// Its inverse: the largest w that shakes down at f = F_T/(mu F_N) in [0, 1]. Throws
/// std::domain_error for other f.
double amplitude_limit(const LayerContact& contact, double f);

}  // namespace tricontact::theory
