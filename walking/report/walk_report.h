#pragma once

#include <string>
#include <utility>
#include <vector>

#include "walking/machine/walk_case.h"
#include "walking/machine/walk_record.h"
#include "walking/run/walk_run.h"

namespace tricontact::walking {

/// A run of a walking machine and where it came from.
struct WalkReport {
    WalkCase walk_case;
    Walk walk;
    std::vector<std::pair<std::string, std::string>> files = {};  ///< text, path from the report
    std::string command = {};                                     ///< that makes it again
    std::string version = {};                                     ///< of the program
};

/// What the report's figures need of a run: enough of its end for the spectrum of a chaotic one.
inline constexpr Recording report_recording{.start = 100, .tail = 500, .interval = 0.05};

}  // namespace tricontact::walking
