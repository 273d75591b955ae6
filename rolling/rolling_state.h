#pragma once

#include "contact/surface.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// What follows from the fields of a grid under a body: forces, moments, areas, extent and
/// friction's dissipation. Slip and dissipation of `surface` are those per rolled way, its offset
/// is the contact's centre.
RollingState state_of(const contact::Surface& surface, const contact::Indenter& indenter);

}  // namespace tricontact::rolling
