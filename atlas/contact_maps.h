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

// On a half-space, normal and tangential contact uncoupled (atlases sphere_half_space_static and
// sphere_half_space). `poisson`: the substrate's, of two bodies sum(nu/G)/sum(1/G).

/// u_stat, the shift under F_T before it rolls; of nu = 0 that of Cattaneo and Mindlin.
Value static_shift_ratio(double f, double poisson);
/// u_sd after shakedown.
Value settled_shift_ratio(double w, double f, double angle, double poisson);
/// kappa of the settled shift: f = 1 - kappa w u_sd - (1 - u_sd)^(3/2).
Value mapping_parameter(double w, double f, double angle, double poisson);

// The same where the interface carries a shear strength alone, f = F_T/(pi tau_0 a^2) (atlases
// sphere_half_space_strength_static and sphere_half_space_strength); the limit is
// theory::strength_rolling.exact_limit.

/// u_stat; of nu = 0 theory::strength_rolling.static_shift.
Value strength_static_shift_ratio(double f, double poisson);
/// u_sd after shakedown.
Value strength_settled_shift_ratio(double w, double f, double angle, double poisson);
/// kappa of it: f = 2/pi [arcsin u_sd + u_sd sqrt(1 - u_sd^2)] - kappa w u_sd, 4/pi of MDR.
Value strength_mapping_parameter(double w, double f, double angle, double poisson);

/// Shift of each period while ratcheting, Delta u = Delta U/U_max, once it is steady (atlas
/// sphere_half_space_ratcheting). f above the limit of shakedown.
Value shift_increment_ratio(double w, double f, double angle, double poisson);

// The method of dimensionality reduction (MDR) beside it: its settled shift has a closed form,
// theory::settled_shift_ratio.

/// Its Delta u (atlas sphere_springs_ratcheting).
Value mdr_shift_increment_ratio(double w, double f);
/// What makes MDR right: u_sd of the half-space at the load under which MDR settles at `mdr_shift`,
/// f = 1 - 3/2 w u - (1 - u)^(3/2). std::domain_error unless 0 < mdr_shift < 1 - w^2.
Value settled_shift_of_mdr(double mdr_shift, double w, double angle, double poisson);
/// The same of ratcheting: Delta u of the half-space where MDR has `mdr_increment`. By bisection
/// over the loads that both atlases have; OutsideDomain where MDR has it at none.
Value shift_increment_of_mdr(double mdr_increment, double w, double angle, double poisson);

/// A layer bonded to a rigid base.
struct BondedLayer {
    double thickness_ratio;  ///< b over the contact diameter on the half-space at the same force
    double poisson;
    double friction_coefficient;  ///< the coupling by the layer makes ratios depend on it
};

// The same on a layer that is pressed with friction in 20 steps or more (atlases
// sphere_layer_static and sphere_layer, its limit of shakedown from sphere_layer_pressed); the
// error of the limit is in the bars.

Value static_shift_ratio(double f, const BondedLayer& layer);
Value settled_shift_ratio(double w, double f, double angle, const BondedLayer& layer);
Value mapping_parameter(double w, double f, double angle, const BondedLayer& layer);
/// Delta u of an incompressible layer, nu = 1/2 (atlas sphere_layer_ratcheting); f above its limit.
Value shift_increment_ratio(double w, double f, double angle, const BondedLayer& layer);
/// u_sd of the layer, all over its own scales, where MDR settles at `mdr_shift`.
Value settled_shift_of_mdr(double mdr_shift, double w, double angle, const BondedLayer& layer);

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
