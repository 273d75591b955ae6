#pragma once

#include <string>

#include "comparisons/rolling_points.h"

namespace tricontact::comparisons {

/// A run as a sweep stores it, with what fits look at.
inline RollingRun rolling_run(const std::string& model, double w, double f,
                              const std::string& state) {
    RollingRun run{.model = model,
                   .group = "parallel",
                   .point = "w = " + std::to_string(w) + ", f = " + std::to_string(f),
                   .angle = 0,
                   .level = 0,
                   .steps_per_quarter = 1,
                   .results = {}};
    run.results = {{"amplitude_ratio", w},
                   {"tangential_ratio", f},
                   {"static_shift_ratio", 0.1},
                   {"final_shift_ratio", 0.2},
                   {"shift_increment_ratio", 0.},
                   {"periods", 10},
                   {"state", state},
                   {"limit_tangential_ratio", 1 - 1.5 * w + 0.5 * w * w * w}};
    return run;
}

}  // namespace tricontact::comparisons
