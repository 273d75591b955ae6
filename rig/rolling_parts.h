#pragma once

#include "rig/rolling.h"

// The assumptions of a rolling rig, one function each.
namespace tricontact::rig {

Assumption quasi_static_drive(const contact::RollingRig& rig);
Assumption ideal_rolling(const contact::RollingRig& rig);
Assumption half_space(const contact::RollingRig& rig);
Assumption half_space_of_line(const contact::RollingRig& rig);
/// Of both shapes: the thesis' rule for b/D_c, and what is claimed with it.
Criterion thick_enough(Calculation thickness_ratio);
std::string half_space_claim(const contact::RollingRig& rig);
Assumption long_cylinder(const contact::RollingRig& rig);
Assumption elastic_substrate(const contact::RollingRig& rig);
Assumption uncoupled(const contact::RollingRig& rig, const StaticShift& static_shift);
Assumption fitted_constants(const contact::RollingRig& rig);

}  // namespace tricontact::rig
