#pragma once

#include "contact/walking_rig.h"
#include "rig/printed.h"

namespace tricontact::rig {

/// What the evaluation of a micro-walking rig takes for granted, with verdicts. Throws
/// contact::InputError for materials out of range.
RigReport check_rig(const contact::WalkingRig& rig);

}  // namespace tricontact::rig
