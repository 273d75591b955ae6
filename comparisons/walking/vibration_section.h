#pragma once

#include "comparisons/document.h"
#include "comparisons/walking/vibration.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// Spectrum of the spring force with its characteristic frequency beside that of free flight, and
/// its running variance: Wetter (2016), figures 5.24, 5.25 and 4.22.
DocumentSection vibration_section(const WalkReport& report, const Vibration& vibration);

}  // namespace tricontact::comparisons::walking
