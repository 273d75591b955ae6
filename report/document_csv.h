#pragma once

#include <string>

#include "report/document.h"

namespace tricontact::report {

/// The figure's data as CSV, headings with units. Curves and bands: columns side by side, x once
/// for neighbours that share it, errors behind the column they belong to. A map: x, y, value.
/// Strips: a stretch per line. Panels: matrices of kinds. An empty line before each further table.
std::string figure_csv(const Figure& figure);

/// The table with all digits; errors in a column behind their values.
std::string table_csv(const DocumentTable& table);

}  // namespace tricontact::report
