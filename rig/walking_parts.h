#pragma once

#include "contact/walking_rig.h"
#include "rig/assumption.h"

// The assumptions of a micro-walking rig, one function each.
namespace tricontact::rig {

Assumption contact_diameter(const contact::WalkingRig& rig);
Assumption known_stiffness(const contact::WalkingRig& rig);
Assumption similar_stiffness(const contact::WalkingRig& rig);
Assumption rigid_sensor(const contact::WalkingRig& rig);
Assumption rod_as_spring(const contact::WalkingRig& rig);
Assumption no_tilting(const contact::WalkingRig& rig);
Assumption sampled_often(const contact::WalkingRig& rig);

}  // namespace tricontact::rig
