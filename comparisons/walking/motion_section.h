#pragma once

#include "comparisons/document.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// Displacement, height, rotation and spring force over some periods, one period with its phases,
/// and the phase plane: Wetter (2016), figures 4.5, 4.6, 4.17 and 4.18.
DocumentSection motion_section(const WalkReport& report);

}  // namespace tricontact::comparisons::walking
