#pragma once

#include "contact/rolling_rig.h"

namespace tricontact::rig {

/// Whether these are the data of one of the thesis' three rolling rigs (Wetter 2016, tables 5.1.1
/// to 5.1.3): shape, R, b, E_2, mu and F_N. Remarks on the thesis' text are made of no other.
bool is_thesis_rig(const contact::RollingRig& rig);

}  // namespace tricontact::rig
