#pragma once

#include "atlas/atlas.h"

namespace tricontact::atlas {

// Oscillating rolling of a rigid paraboloid under constant loads, where no closed form is exact:
// what boundary elements came to, read from the shipped atlases. Beside each value stands the half
// width of its bar of 95 %. The arguments are those of theory/rolling/oscillating_rolling.h:
//   w = W/a           rolling amplitude over the contact radius, on a layer over its own one,
//   f = F_T/(mu F_N)  tangential force over the friction limit,
//   angle [rad]       between the lines of load and rolling; of any quadrant, by symmetry,
//   u = U/U_max       rigid shift over its unit, on a layer over its own one.
// Every function throws OutsideDomain where its atlas does not reach, naming key and range (those
// of the load are fractions of the limit of shakedown), or where the atlas says no value for its
// long bar; std::out_of_range if the program was built without that atlas. A call takes
// microseconds, each thread's first one milliseconds; from several threads at once too.

// On a half-space, normal and tangential contact uncoupled (atlas sphere_half_space). `poisson`:
// the substrate's, of two bodies sum(nu/G)/sum(1/G).

/// u_stat, the shift under F_T before it rolls; of nu = 0 that of Cattaneo and Mindlin.
Value static_shift_ratio(double f, double poisson);
/// u_sd after shakedown.
Value settled_shift_ratio(double w, double f, double angle, double poisson);
/// kappa of the settled shift: f = 1 - kappa w u_sd - (1 - u_sd)^(3/2).
Value mapping_parameter(double w, double f, double angle, double poisson);

/// A layer bonded to a rigid base.
struct BondedLayer {
    double thickness_ratio;  ///< b over the contact diameter on the half-space at the same force
    double poisson;
    double friction_coefficient;  ///< the coupling by the layer makes ratios depend on it
};

// The same on a layer that is pressed with friction in 20 steps or more (atlas sphere_layer, its
// limit of shakedown from sphere_layer_pressed); the error of the limit is in the bars.

Value static_shift_ratio(double f, const BondedLayer& layer);
Value settled_shift_ratio(double w, double f, double angle, const BondedLayer& layer);
Value mapping_parameter(double w, double f, double angle, const BondedLayer& layer);

// Layers pressed without friction (atlas sphere_layer_pressed), exact but for the bars.

/// Largest f that shakes down, at any angle, uncoupled; of the half-space theory::shakedown_limit.
Value layer_shakedown_limit(double w, double thickness_ratio, double poisson);

/// Layer over half-space at the same normal force.
struct PressedRatios {
    Value contact_radius;  ///< of a
    Value indentation;     ///< of d
    Value peak_pressure;   ///< of p0
    Value unit_shift;      ///< of U_max
};
PressedRatios pressed_layer_ratios(double thickness_ratio, double poisson);

}  // namespace tricontact::atlas
