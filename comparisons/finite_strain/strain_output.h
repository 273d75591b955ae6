#pragma once

#include <string>
#include <vector>

#include "comparisons/finite_strain/strain_deviation.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// "neo-Hookean".
const char* name_of(contact::Case::Law law);

/// "11.9 N", "11.9 N (10.1 to 13.4 N)", "below 2.64 N", "not up to 169 N"; a dash where unknown.
std::string threshold_text(const std::optional<StrainThreshold>& threshold, double first,
                           double last, const std::string& unit);

/// Every point in one long table: F_N, b, f_T, whether rolled, level, quantity, by the linear law,
/// at finite strains, deviation. SI units.
std::string strain_csv(const StrainDeviation& deviation);

/// The case's own point with errors and thresholds, and all points; fixed keys in fixed order,
/// undefined numbers null. `case_text` is that of the resolved case.
std::string strain_json(const std::string& version, const std::string& case_text,
                        const StrainDeviation& deviation);

/// What the linear law means for the case, in sentences with numbers.
std::vector<report::Verdict> strain_verdicts(const StrainDeviation& deviation);

/// The case's own point by quantity, with the forces for 1, 2, 5 %; and all points.
report::DocumentTable strain_table(const StrainDeviation& deviation);
report::DocumentTable strain_points_table(const StrainDeviation& deviation);

/// Maps over F_N and b, one per quantity; curves over F_N and over f_T.
std::vector<report::Figure> strain_maps(const StrainDeviation& deviation);
std::vector<report::Figure> strain_curves(const StrainDeviation& deviation);

/// Verdicts, the case's own point, maps, curves, how it was computed.
report::Document strain_document(const StrainDeviation& deviation);

}  // namespace tricontact::comparisons
