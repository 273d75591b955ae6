#pragma once

#include <optional>
#include <vector>

#include "statistics/spectrum.h"
#include "walking/machine/machine.h"
#include "walking/machine/walk_record.h"

namespace tricontact::walking {

/// How the spring force vibrates at the end of a run; forces over that of steady sliding, times in
/// units of sqrt(m/k_x).
struct Vibration {
    statistics::Spectrum spectrum;
    statistics::CharacteristicFrequency characteristic;
    double free_flight = 0;         ///< frequency while the body is in the air
    double window = 0;              ///< of the running variance, ten characteristic periods
    std::vector<double> variances;  ///< one per place of the window; empty if it does not fit
    double interval = 0;            ///< between two places
    double instability = 0;         ///< share of them above the threshold; NaN for none
};

/// Variance above which Wetter (2016), section 4.3.1, takes the motion as unstable.
inline constexpr double instability_threshold = 0.1;

/// From the recorded end of the run; nothing where that is too short.
std::optional<Vibration> vibration_of(const Machine& machine, const Walk& walk);

/// Half width of the 95 % interval of the instability, by Geyer's initial sequence; NaN if it has
/// none.
double instability_error(const Vibration& vibration);

}  // namespace tricontact::walking
