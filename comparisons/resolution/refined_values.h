#pragma once

#include <optional>
#include <vector>

#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/results.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::comparisons {

/// Everything that a refinement is made from.
struct RefinedLevels : RefinedCase {
    std::vector<Results> values;         ///< per level
    std::optional<Results> wide;         ///< at the finest level but one
    std::optional<PressedValues> exact;  ///< by theory
    double tolerance = 0;                ///< of the solvers [-]: smaller relative changes are noise
};

/// Of all quantities that are refined and that every level has.
Refinement make_refinement(const RefinedLevels& levels);

}  // namespace tricontact::comparisons
