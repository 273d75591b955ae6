#pragma once

#include <optional>
#include <vector>

#include "dynamics/machine.h"
#include "dynamics/spectrum.h"
#include "dynamics/walk_record.h"

namespace tricontact::comparisons::walking {

/// How the spring force vibrates at the end of a run; forces over that of steady sliding, times in
/// units of sqrt(m/k_x).
struct Vibration {
    dynamics::Spectrum spectrum;
    dynamics::CharacteristicFrequency characteristic;
    double free_flight = 0;         ///< frequency while the body is in the air
    double window = 0;              ///< of the running variance, ten characteristic periods
    std::vector<double> variances;  ///< one per place of the window; empty if it does not fit
    double interval = 0;            ///< between two places
    double instability = 0;         ///< share of them above the threshold; NaN for none
};

/// Variance above which Wetter (2016), section 4.3.1, takes the motion as unstable.
inline constexpr double instability_threshold = 0.1;

/// From the recorded end of the run; nothing where that is too short.
std::optional<Vibration> vibration_of(const dynamics::Machine& machine, const dynamics::Walk& walk);

/// Half width of the 95 % interval of the instability, by Geyer's initial sequence; NaN if it has
/// none.
double instability_error(const Vibration& vibration);

}  // namespace tricontact::comparisons::walking
