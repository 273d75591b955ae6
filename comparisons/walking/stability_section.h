#pragma once

#include <complex>
#include <vector>

#include "comparisons/document.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// Linear stability of steady sliding, from which vibration may or may not start by itself.
struct SlidingStability {
    bool exists = false;  ///< else the body tilts
    std::vector<std::complex<double>>
        eigenvalues;  ///< [sqrt(k_x/m)], Im >= 0, fastest growth first
};

SlidingStability sliding_stability(const dynamics::Machine& machine);
/// Small disturbances neither grow nor decay.
bool is_neutral(const SlidingStability& stability);

Verdict stability_verdict(const WalkReport& report, const SlidingStability& stability);

DocumentSection stability_section(const SlidingStability& stability);

}  // namespace tricontact::comparisons::walking
