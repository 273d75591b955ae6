#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/document.h"

namespace tricontact::report {

/// Typeset for plotly.js, which knows tags, but of the escaped characters not the quotes.
std::string chart_label(const std::string& text);

/// What document.js draws: the figure's own data, NaN as null, and the numbers of its styles (see
/// FigureStyles), null for grey.
nlohmann::ordered_json figure_json(const Figure& figure);

/// charts.js and, in front, the colours of maps (plot_style.h), for the scripts that come after it.
std::string charts_script();

/// JSON as it may stand inside an HTML script element, which an angle bracket could end. Bytes that
/// are no UTF-8 are replaced.
std::string script_json(const nlohmann::ordered_json& content);

}  // namespace tricontact::report
