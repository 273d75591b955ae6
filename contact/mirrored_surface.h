#pragma once

#include "contact/solvers/compliance.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// The whole surface from its half with y >= 0: x and normal components even in y, y components
/// odd. Points at y = 0 are not doubled.
Surface mirrored(Surface half);
/// The same of states at points, in the same order.
std::vector<ContactState> mirrored(const std::vector<ContactState>& half,
                                   const ContactPoints& points);

}  // namespace tricontact::contact
