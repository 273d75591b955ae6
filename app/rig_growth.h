#pragma once

#include <optional>

#include "contact/case.h"
#include "experiments/assumptions/check_rig.h"

namespace tricontact::app {

/// A rig's sphere, taken as a rigid paraboloid, on its layer under F_N and
/// experiments::coupling_tangential_ratio, pressed with friction in the usual steps.
contact::Case sphere_on_layer(const experiments::Rig& rig);

/// What rolling makes of the static shift, by the maps of layer and half-space: an
/// experiments::RolledGrowth. Throws contact::InputError where no map is about the rig.
std::optional<experiments::Growth> rolled_growth(const experiments::Rig& rig);

}  // namespace tricontact::app
