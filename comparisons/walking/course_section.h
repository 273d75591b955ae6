#pragma once

#include "comparisons/document.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// The whole run: means and extremes over windows of time with the end of the transient, and its
/// Poincare section as a return map.
DocumentSection course_section(const WalkReport& report);

}  // namespace tricontact::comparisons::walking
