#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "report/document.h"
#include "rolling/rolling_report.h"

namespace tricontact::rolling {

/// The report of `tricontact roll`.
report::Document rolling_document(const RollingReport& report);

/// "models", "theories" and "creep_ratio" of summary.json (docs/rolling.md); SI units.
nlohmann::ordered_json rolling_json(const RollingReport& report);

/// The transient of one model, a row per step, SI units; the last row, of infinite distance left
/// empty, is the steady state.
std::string history_csv(const RollingRun& run);

/// Creep curves of all models and theories: steady states, force ratio over creepage. Theories
/// stand at the same creepages as the first model that has a curve.
std::string creep_csv(const RollingReport& report);

}  // namespace tricontact::rolling
