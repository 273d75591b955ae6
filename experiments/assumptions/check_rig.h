#pragma once

#include <functional>

#include "experiments/assumptions/printed.h"
#include "experiments/assumptions/rolling_rig.h"
#include "experiments/assumptions/walking_rig.h"

namespace tricontact::experiments {

/// F_T/(mu F_N) at which the effect of the layer's coupling is told.
inline constexpr double coupling_tangential_ratio = 0.56;

/// Shift [m] of the rig's sphere on its layer under F_N and `coupling_tangential_ratio`, normal and
/// tangential contact coupled or not: by a model that the caller has.
using StaticShift = std::function<double(const RollingRig& rig, bool coupled)>;

/// What the evaluation of a rolling rig takes for granted, with verdicts. `static_shift` empty: the
/// effect of coupling stays open. Throws contact::InputError for a rig out of the range of the
/// layer's theory, contact::NotConverged.
RigReport check_rig(const RollingRig& rig, const StaticShift& static_shift = {});

/// What the evaluation of a micro-walking rig takes for granted, with verdicts. Throws
/// contact::InputError for materials out of range.
RigReport check_rig(const WalkingRig& rig);

}  // namespace tricontact::experiments
