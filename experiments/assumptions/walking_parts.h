#pragma once

#include <string_view>
#include <vector>

#include "contact/substrates/material.h"
#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/rig.h"

// The quantities and formulas of a micro-walking rig, and its assumptions, one function each.
namespace tricontact::experiments {

inline constexpr double gravity = 9.81;  ///< [m/s^2]

/// By the keys of walking_formulas.cc.
std::vector<Given> given(const WalkingRig& rig, std::string_view keys);

/// E_1, nu_1, E_2, nu_2 of disc and substrate.
inline constexpr const char* material_keys = "E_1 nu_1 E_2 nu_2";
/// Of values that begin in this order.
contact::MaterialPair pair_of(const Values& x);

/// k_x, k_z [N/m] of one contact; b [m], half the distance of the discs' outer faces; a [m], height
/// of the axis over the contacts at 45 degrees.
extern const Formula tangential_stiffness, normal_stiffness, half_width, half_height;
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
