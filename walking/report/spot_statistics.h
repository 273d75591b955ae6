#pragma once

#include <cstddef>
#include <vector>

#include "report/document.h"
#include "walking/report/walk_report.h"

namespace tricontact::walking {

/// Of more spots single ones are neither drawn nor told.
inline constexpr std::size_t most_spots = 4;

/// Statistics of a contact spot; their errors are half widths of 95 % intervals from the scatter
/// over the run, NaN on a limit cycle, which has none.
struct SpotStatistics {
    int number = 1;
    report::WithError stick_time;   ///< share of time
    report::WithError correlation;  ///< of velocity and normal deflection
};

/// Of each spot, after the transient; empty where there are none.
std::vector<SpotStatistics> spot_statistics(const WalkReport& report);

}  // namespace tricontact::walking
