#pragma once

#include <string_view>

namespace tricontact::report {

/// The script that draws charts (plotly.js), its licence in front, embedded when the program is
/// built: cmake/charts.cmake. It defines `Plotly`.
std::string_view chart_library();

}  // namespace tricontact::report
