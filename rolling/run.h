#pragma once

#include <vector>

#include "contact/substrates/substrate.h"
#include "rolling/rolling_contact.h"
#include "rolling/steady_rolling.h"
#include "rolling/transient_rolling.h"

namespace tricontact::rolling {

/// Rolls from rest over problem.distance, and finds the steady state: of elastic bodies directly,
/// over a relaxing substrate by rolling on until nothing changes any more. Throws
/// contact::InputError for points that form no grid or a force above the friction limit,
/// contact::ContactAtEdge of the grid, contact::NotConverged.
RollingHistory run(const contact::Substrate& substrate, const RollingProblem& problem);

/// Rolls on over a relaxing substrate until nothing changes any more: the steady state that has no
/// equation of its own. `states` are those from rest on. Throws contact::NotConverged.
SteadyRolling roll_until_steady(TransientRolling& rolling, std::vector<RollingState> states);

}  // namespace tricontact::rolling
