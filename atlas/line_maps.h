#pragma once

#include "atlas/contact_maps.h"

namespace tricontact::atlas {

// Oscillating rolling of a rigid cylinder across its axis under constant loads, in plane strain.
// Arguments, bars and what is thrown are those of contact_maps.h, `a` the half width; what has a
// closed form on the half-space is in theory/oscillating_cylinder.h.

/// Delta u of each period while ratcheting on an uncoupled half-space, once it is steady (atlas
/// cylinder_half_space_ratcheting). f above theory::line_shakedown_limit(w). `lambda`: of the
/// contact's own length, contact::line_shift_factor(); shifts over U_max go with its inverse.
Value line_shift_increment_ratio(double w, double f, double lambda);

// On a layer bonded to a rigid base, of which no result knows the length of the cylinder (atlases
// cylinder_layer_pressed, cylinder_layer_static, cylinder_layer and cylinder_layer_ratcheting);
// pressed with friction in 20 steps or more but where the contact has no friction.

/// What stands for lambda of the half-space: U_max = mu 2 F_N/(pi E* L) times it, frictionless.
Value line_layer_shift_factor(double thickness_ratio, double poisson);
/// Largest f that shakes down, uncoupled; of the half-space theory::line_shakedown_limit.
Value line_layer_shakedown_limit(double w, double thickness_ratio, double poisson);
Value line_static_shift_ratio(double f, const BondedLayer& layer);
Value line_settled_shift_ratio(double w, double f, const BondedLayer& layer);
/// Of an incompressible layer, nu = 1/2.
Value line_shift_increment_ratio(double w, double f, const BondedLayer& layer);

}  // namespace tricontact::atlas
