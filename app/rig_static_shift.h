#pragma once

#include "contact/rolling_rig.h"

namespace tricontact::app {

/// Shift [m] of a rig's sphere, taken as a rigid paraboloid, on its layer by `bem-layer`: under
/// F_N, pressed with friction in the usual steps, and rig::coupling_tangential_ratio; 22 cells in
/// the contact radius. Throws contact::NotConverged.
double static_shift(const contact::RollingRig& rig, bool coupled);

}  // namespace tricontact::app
