#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// A field output report of Abaqus (.rpt): tables below "Field Output reported at nodes for part:
/// LAYER", of each part the last state, whose tables of the same nodes are joined. `set`: a part,
/// or empty for the only one with contact. A report of curves is a table of columns. Throws
/// contact::InputError.
MeshField parse_rpt(std::string_view text, const std::string& name, const std::string& set);

/// The lines "Total" of reaction forces: along z, or y where there is no z. Throws
/// contact::InputError where there are none.
std::map<std::string, Total> parse_rpt_totals(std::string_view text, const std::string& name);

/// Whether it is such a report.
bool is_field_report(std::string_view text);

}  // namespace tricontact::benchmarks
