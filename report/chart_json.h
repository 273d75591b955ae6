#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/document.h"

namespace tricontact::report {

/// Typeset for plotly.js, which knows tags, but of the escaped characters not the quotes.
std::string chart_label(const std::string& text);

/// What document.js draws: {"colours": [...], "figures": [...]} with the figures' own data, NaN as
/// null. Curves carry the number of their style (colour and marker), null for the grey of theory:
/// their own, else that of an earlier curve of the same name, else the next that no curve uses.
/// Bands have their own, else that of the curve of their name.
nlohmann::ordered_json chart_json(const std::vector<Figure>& figures);

}  // namespace tricontact::report
