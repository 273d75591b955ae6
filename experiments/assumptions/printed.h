#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/printed_value.h"
#include "experiments/assumptions/rolling_rig.h"

namespace tricontact::experiments {

/// The contact of a rig's sphere over the normal force, by both theories: what a measurement of
/// either would have to tell apart. SI units.
struct ForceCurves {
    std::vector<double> force;  ///< up to one and a half times that of the rig [N]
    std::vector<double> hertz_diameter, layer_diameter;        ///< 2 a [m]
    std::vector<double> hertz_indentation, layer_indentation;  ///< d [m]
    statistics::Uncertain rig_force;                           ///< F_N [N]
    std::optional<statistics::Uncertain> measured_diameter;    ///< at that force [m]
};

/// Throws contact::InputError for a layer too thin for its theory.
ForceCurves force_curves(const RollingRig& rig);

/// A published number beside the same number computed from the rig's data.
struct PrintedCheck {
    enum class Agreement {
        agrees,        ///< equal when rounded like the print
        within_error,  ///< not that, but closer than the printed or propagated error
        differs,
        not_computed  ///< the rig file lacks what the formula needs
    };

    PrintedValue printed;
    std::optional<Calculation> calculation;
    Agreement agreement = Agreement::not_computed;
    double ratio = 0;  ///< printed over computed
    /// Printed error over the propagated one, if both are there, ...
    std::optional<double> error_ratio;
    bool error_agrees = true;  ///< ... and whether they are equal when rounded like the print
    std::vector<Substitute> substitutes;  ///< which the print would follow from, if it differs
};

/// What follows about an experiment.
struct RigReport {
    std::string title;
    std::vector<Assumption> assumptions = {};
    std::vector<PrintedCheck> printed = {};
    std::optional<ForceCurves> curves = {};  ///< of a sphere
};

/// Looks the printed quantities up by name among the calculations of the assumptions.
std::vector<PrintedCheck> check_printed(const std::vector<PrintedValue>& printed,
                                        const std::vector<Assumption>& assumptions);

}  // namespace tricontact::experiments
