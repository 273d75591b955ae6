#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/half_space/half_space_deviation.h"

namespace tricontact::comparisons {

/// One quantity on the case's own layer.
struct DeviationRow {
    const Quantity* quantity = nullptr;
    bool computed = false;             ///< by boundary elements, else exact
    std::optional<RolledRatio> ratio;  ///< layer over half-space
    /// On layers of its material and base; empty where unknown.
    std::optional<NeededThicknesses> needed;
};

/// All quantities that are defined for the case, exact ones first.
std::vector<DeviationRow> rows_here(const HalfSpaceDeviation& deviation);

/// "37.6", "12.1 (11.2 to 14.0)", "below 0.1": the thinnest layer that was looked at.
std::string needed_text(const NeededThickness& needed, double thinnest);
/// That of a quantity's row.
double thinnest_of(const HalfSpaceDeviation& deviation, const DeviationRow& row);

const char* name_of(theory::LayerBase base);

}  // namespace tricontact::comparisons
