#pragma once

#include <optional>

#include "contact/case.h"
#include "experiments/assumptions/check_rig.h"

namespace tricontact::experiments {

/// A rig's sphere, taken as a rigid paraboloid, on its layer under F_N and
/// coupling_tangential_ratio, pressed with friction in the usual steps.
contact::Case sphere_on_layer(const Rig& rig);

/// What rolling makes of the static shift, by the maps of layer and half-space: an
/// RolledGrowth. Throws contact::InputError where no map is about the rig.
std::optional<Growth> rolled_growth(const Rig& rig);

}  // namespace tricontact::experiments
