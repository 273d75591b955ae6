#pragma once

#include "contact/surface.h"

namespace tricontact::contact {

/// The whole surface from its half with y >= 0: x and normal components even in y, y components
/// odd. Points at y = 0 are not doubled. Nodes layout only.
Surface mirrored(const Surface& half);

}  // namespace tricontact::contact
