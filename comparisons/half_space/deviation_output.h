#pragma once

#include <string>

#include "comparisons/half_space/half_space_deviation.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Every ratio in one long table: part ("exact", "computed"), base, poisson, coupled, b over D_c,
/// quantity, ratio layer over half-space, its error.
std::string deviation_csv(const HalfSpaceDeviation& deviation);

/// The case's own layer, the needed thicknesses and all ratios, fixed keys in fixed order,
/// undefined numbers null. `case_text` is that of the resolved case.
std::string deviation_json(const std::string& version, const std::string& case_text,
                           const HalfSpaceDeviation& deviation);

/// What the case's layer means, in sentences with numbers.
std::vector<report::Verdict> deviation_verdicts(const HalfSpaceDeviation& deviation);

/// Lines for the console: the case's layer by quantity, with the needed thicknesses.
std::string deviation_text(const HalfSpaceDeviation& deviation);

/// Verdicts, the case's layer, maps, curves, needed thicknesses, how it was computed.
report::Document deviation_document(const HalfSpaceDeviation& deviation);

}  // namespace tricontact::comparisons
