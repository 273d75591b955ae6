#pragma once

#include "contact/substrate.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// Rolls from rest over problem.distance, and finds the steady state: of elastic bodies directly,
/// over a relaxing substrate by rolling on until nothing changes any more. Throws
/// contact::InputError for points that form no grid or a force above the friction limit,
/// contact::ContactAtEdge of the grid, contact::NotConverged.
RollingHistory run(const contact::Substrate& substrate, const RollingProblem& problem);

}  // namespace tricontact::rolling
