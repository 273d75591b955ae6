#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/layer.h"
#include "comparisons/refinement.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// Results of one level by name (see RefinedQuantity::name), SI units.
using LevelValues = std::map<std::string, double>;

/// F_N, d, a, p0, U_max, the static shift, and with rolling the last one and its last increment.
LevelValues level_values(const contact::Case& c, const contact::History& history);

/// Everything that a refinement is made from.
struct RefinedLevels {
    std::string model, key;
    std::vector<double> sizes;        ///< [m], decreasing
    std::vector<double> cpu_s;        ///< per level
    std::vector<LevelValues> values;  ///< per level
    std::optional<LevelValues> wide;  ///< at the finest level but one
    double wide_factor = 0;
    std::optional<PressedValues> exact;
    std::string exact_name;  ///< whose theory that is
    double tolerance = 0;    ///< of the solvers [-]: smaller relative changes are noise
};

/// Of all quantities that every level has.
Refinement make_refinement(const RefinedLevels& levels);

}  // namespace tricontact::comparisons
