#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/rig.h"

namespace tricontact::experiments {

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

/// Looks the printed quantities up by name among the calculations of the assumptions.
std::vector<PrintedCheck> check_printed(const std::vector<PrintedValue>& printed,
                                        const std::vector<Assumption>& assumptions);

}  // namespace tricontact::experiments
