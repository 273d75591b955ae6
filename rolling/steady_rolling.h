#pragma once

#include "contact/history.h"
#include "contact/solvers/compliance.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

struct SteadyRolling {
    RollingState state;
    contact::Surface surface;  ///< slip [-] and dissipation [Pa] per rolled way
    contact::Audit audit;
};

/// The steady state of elastic bodies, solved directly; coupled normal and tangential contact by
/// staggered iteration (Panagiotopoulos 1975), accelerated (see contact::FixedPoint). Throws
/// contact::InputError for points that form no grid or a force above the friction limit,
/// contact::ContactAtEdge of the grid, contact::NotConverged.
SteadyRolling steady_rolling(const contact::Compliance& compliance, const RollingProblem& problem);

}  // namespace tricontact::rolling
