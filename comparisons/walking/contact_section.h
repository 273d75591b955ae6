#pragma once

#include "comparisons/document.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// Forces of the contact spots over some periods with what the spots do; of many spots how many
/// stick, slip and are released.
DocumentSection contact_section(const WalkReport& report);

}  // namespace tricontact::comparisons::walking
