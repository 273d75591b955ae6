#pragma once

#include "contact/case.h"

namespace tricontact::contact {

/// Whether the pressure falls from the centre on, as Hertz' does: not under power laws of n > 2,
/// punches and rough bodies, and of the profile of a table nobody knows. Then the least pressure on
/// a path is that at one of its ends.
bool pressure_falls(const Case& c);

}  // namespace tricontact::contact
