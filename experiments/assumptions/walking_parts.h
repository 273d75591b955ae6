#pragma once

#include "experiments/assumptions/rig_quantities.h"

// The quantities and formulas of a micro-walking rig, for the files of its assumptions.
namespace tricontact::experiments {

inline constexpr double gravity = 9.81;  ///< [m/s^2]

/// k_x, k_z [N/m] of one contact; b [m], half the distance of the discs' outer faces; a [m], height
/// of the axis over the contacts at 45 degrees.
extern const Formula tangential_stiffness, normal_stiffness, half_width, half_height;
/// m g of four contacts under planes at 45 degrees [N].
RigNumber spot_force(const Rig& rig);
/// Of spring and sensor in series [N/m]; the spring's own without a sensor.
Calculation spring_stiffness(const Rig& rig);

}  // namespace tricontact::experiments
