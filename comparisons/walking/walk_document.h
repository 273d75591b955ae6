#pragma once

#include "comparisons/document.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// What a machine does after its transient: verdicts, the motion and forces of figures 4.5, 4.6 and
/// 4.17 to 4.19 of Wetter (2016), the whole run, its section, spectrum and running variance.
Document walk_document(const WalkReport& report);

}  // namespace tricontact::comparisons::walking
