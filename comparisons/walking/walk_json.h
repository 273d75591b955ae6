#pragma once

#include <nlohmann/json.hpp>

#include "dynamics/walk_case.h"
#include "dynamics/walk_record.h"

namespace tricontact::comparisons::walking {

/// The numbers of a run, dimensionless as dynamics/walk_result.h has them; "dimensional" holds
/// those in SI units, null for a machine without dimensions. Undefined numbers are null. Spots are
/// numbered from 1, left to right: stick_time_1, correlation_1 ...
nlohmann::ordered_json walk_json(const dynamics::WalkCase& walk_case, const dynamics::Walk& walk);

}  // namespace tricontact::comparisons::walking
