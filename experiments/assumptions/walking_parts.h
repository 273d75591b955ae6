#pragma once

#include <vector>

#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/calculation.h"
#include "experiments/assumptions/walking_rig.h"

// Stiffnesses of a micro-walking rig, as several assumptions need them.
// The assumptions of a micro-walking rig, one function each.
namespace tricontact::experiments {

inline constexpr double gravity = 9.81;  ///< [m/s^2]

/// E_1, nu_1, E_2, nu_2 of disc and substrate.
std::vector<Given> material_given(const WalkingRig& rig);
/// Of values that begin in this order [Pa].
double effective_modulus_of(const std::vector<double>& x);
double effective_shear_modulus_of(const std::vector<double>& x);

Given mass(const WalkingRig& rig);
Given diameter(const WalkingRig& rig);

/// k_x = G* D_c [N/m] of one contact (5.2.3).
Calculation tangential_stiffness(const WalkingRig& rig);
/// k_z = E* D_c [N/m] of one contact (5.2.3).
Calculation normal_stiffness(const WalkingRig& rig);
/// b = l_1/2 + l_2 [m] of the model, half the distance of the discs' outer faces.
Calculation half_width(const WalkingRig& rig);
/// a = D/(2 sqrt(2)) [m] of the model: height of the axis over the contacts at 45 degrees.
Calculation half_height(const WalkingRig& rig);
/// Of spring and sensor in series [N/m]; the spring's own without a sensor.
Calculation spring_stiffness(const WalkingRig& rig);

Assumption contact_diameter(const WalkingRig& rig);
Assumption known_stiffness(const WalkingRig& rig);
Assumption similar_stiffness(const WalkingRig& rig);
Assumption rigid_sensor(const WalkingRig& rig);
Assumption rod_as_spring(const WalkingRig& rig);
Assumption no_tilting(const WalkingRig& rig);
Assumption sampled_often(const WalkingRig& rig);

}  // namespace tricontact::experiments
