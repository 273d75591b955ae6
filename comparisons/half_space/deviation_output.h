#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/half_space/half_space_deviation.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// One quantity on the case's own layer.
struct DeviationRow {
    const Quantity* quantity = nullptr;
    bool computed = false;             ///< by boundary elements, else exact
    std::optional<RolledRatio> ratio;  ///< layer over half-space
    /// On layers of its material and base; null where unknown.
    const NeededThicknesses* needed = nullptr;
    double thinnest = 0;  ///< of these, over D_c
};

/// All quantities that are defined for the case, exact ones first.
std::vector<DeviationRow> rows_here(const HalfSpaceDeviation& deviation);

/// "37.6", "12.1 (11.2 to 14.0)", "below 0.1": the thinnest layer that was looked at.
std::string needed_text(const NeededThickness& needed, double thinnest);

const char* name_of(theory::LayerBase base);

/// Every ratio in one long table: part ("exact", "computed"), base, poisson, coupled, b over D_c,
/// quantity, ratio layer over half-space, its error.
std::string deviation_csv(const HalfSpaceDeviation& deviation);

/// The case's own layer, the needed thicknesses and all ratios, fixed keys in fixed order,
/// undefined numbers null. `case_text` is that of the resolved case.
std::string deviation_json(const std::string& version, const std::string& case_text,
                           const HalfSpaceDeviation& deviation);

/// What the case's layer means, in sentences with numbers.
std::vector<report::Verdict> deviation_verdicts(const HalfSpaceDeviation& deviation);

/// The case's layer by quantity, with the needed thicknesses.
report::DocumentTable deviation_table(const HalfSpaceDeviation& deviation);

/// Verdicts, the case's layer, maps, curves, needed thicknesses, how it was computed.
report::Document deviation_document(const HalfSpaceDeviation& deviation);

/// Exact quantities over the thickness for the case's material: ratios, then deviations in percent
/// on logarithmic axes beside what boundary elements computed.
std::vector<report::Figure> thickness_figures(const HalfSpaceDeviation& deviation);

/// Deviation of bonded layers over thickness and nu, one map per quantity; two of them over the
/// thickness for several nu and both bases.
std::vector<report::Figure> map_figures(const HalfSpaceDeviation& deviation);

/// Computed ratios over the thickness with their errors, one figure per quantity.
std::vector<report::Figure> rolled_figures(const HalfSpaceDeviation& deviation);

}  // namespace tricontact::comparisons
