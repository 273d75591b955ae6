#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/printed_value.h"
#include "rig/assumption.h"
#include "rig/force_curves.h"

namespace tricontact::rig {

/// A published number beside the same number computed from the rig's data.
struct PrintedCheck {
    enum class Agreement {
        agrees,        ///< equal when rounded like the print
        within_error,  ///< not that, but closer than the printed or propagated error
        differs,
        not_computed  ///< the rig file lacks what the formula needs
    };

    contact::PrintedValue printed;
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
std::vector<PrintedCheck> check_printed(const std::vector<contact::PrintedValue>& printed,
                                        const std::vector<Assumption>& assumptions);

}  // namespace tricontact::rig
