#pragma once

#include "experiments/assumptions/rolling_rig.h"

namespace tricontact::app {

/// Shift [m] of a rig's sphere, taken as a rigid paraboloid, on its layer by `bem-layer`: under
/// F_N, pressed with friction in the usual steps, and experiments::coupling_tangential_ratio; 22
/// cells in the contact radius. Throws contact::NotConverged.
double static_shift(const experiments::RollingRig& rig, bool coupled);

}  // namespace tricontact::app
