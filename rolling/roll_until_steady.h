#pragma once

#include <vector>

#include "rolling/steady_rolling.h"
#include "rolling/transient_rolling.h"

namespace tricontact::rolling {

/// Rolls on over a relaxing substrate until nothing changes any more: the steady state that has no
/// equation of its own. `states` are those from rest on. Throws contact::NotConverged.
SteadyRolling roll_until_steady(TransientRolling& rolling, std::vector<RollingState> states);

}  // namespace tricontact::rolling
