#pragma once

#include <optional>
#include <vector>

#include "contact/rolling_rig.h"

namespace tricontact::rig {

/// The contact of a rig's sphere over the normal force, by both theories: what a measurement of
/// either would have to tell apart. SI units.
struct ForceCurves {
    std::vector<double> force;  ///< up to one and a half times that of the rig [N]
    std::vector<double> hertz_diameter, layer_diameter;        ///< 2 a [m]
    std::vector<double> hertz_indentation, layer_indentation;  ///< d [m]
    contact::Uncertain rig_force;                              ///< F_N [N]
    std::optional<contact::Uncertain> measured_diameter;       ///< at that force [m]
};

/// Throws contact::InputError for a layer too thin for its theory.
ForceCurves force_curves(const contact::RollingRig& rig);

}  // namespace tricontact::rig
