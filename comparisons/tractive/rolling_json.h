#pragma once

#include <nlohmann/json.hpp>

#include "comparisons/tractive/rolling_report.h"

namespace tricontact::comparisons::tractive {

/// "models", "theories" and "creep_ratio" of summary.json (docs/rolling.md); SI units.
nlohmann::ordered_json rolling_json(const RollingReport& report);

}  // namespace tricontact::comparisons::tractive
