#pragma once

#include <string>
#include <vector>

#include "comparisons/shakedown/rolling_points.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

/// Without anything still to come; U_max = 2.
inline void settle(Results& r, double shift_ratio) {
    r.set(quantities::settled_shift_ratio, shift_ratio);
    r.set(quantities::settled_shift, 2 * shift_ratio);
    r.set(quantities::settled_shift_error_ratio, 0.);
}

/// A run as a sweep stores it, with what fits look at.
inline RollingRun rolling_run(const std::string& model, double w, double f, contact::State state) {
    RollingRun run{.model = model,
                   .group = "parallel",
                   .point = "w = " + std::to_string(w) + ", f = " + std::to_string(f),
                   .angle = 0,
                   .level = 0,
                   .steps_per_quarter = 1,
                   .results = {}};
    using namespace quantities;
    Results& r = run.results;
    r.set(quantities::amplitude_ratio, w);
    r.set(quantities::tangential_ratio, f);
    r.set(unit_shift, 2.);
    r.set(static_shift_ratio, 0.1);
    r.set(final_shift_ratio, 0.2);
    r.set(shift_increment_ratio, 0.);
    r.set(periods, 10);
    r.set(quantities::state, state);
    r.set(limit_tangential_ratio, 1 - 1.5 * w + 0.5 * w * w * w);
    r.set(limit_amplitude_ratio, theory::amplitude_limit(f));
    if (state == contact::State::shakedown) settle(r, 0.2);
    return run;
}

inline constexpr double amplitudes[] = {0.1, 0.24, 0.38, 0.51, 0.62, 0.74};
inline constexpr double loads[] = {0.05, 0.09, 0.24, 0.44, 0.56, 0.7, 0.8, 0.9};

/// Settled points of the closed form with this kappa.
inline std::vector<RollingPoint> settled_points(double kappa, const char* model = "mdr") {
    std::vector<RollingRun> runs;
    for (const double w : amplitudes)
        for (const double f : loads) {
            const auto u = theory::settled_shift_ratio(w, f, kappa);
            // The largest kappa has the lowest limit.
            if (!u || f > theory::shakedown_limit(w)) continue;
            runs.push_back(rolling_run(model, w, f, contact::State::shakedown));
            settle(runs.back().results, *u);
        }
    return rolling_points(runs);
}

}  // namespace tricontact::comparisons
