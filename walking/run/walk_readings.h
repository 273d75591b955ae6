#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/document.h"
#include "statistics/spectrum.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/run/walk.h"

namespace tricontact::walking {

/// A value of the snapshots over t* = t - t_0.
template <class Value>
report::Curve over_time(std::span<const Snapshot> snapshots, const std::string& name,
                        const Value& value) {
    report::Curve curve{.name = name};
    for (const Snapshot& snapshot : snapshots)
        curve.add(snapshot.motion.time - snapshots.front().motion.time, value(snapshot));
    return curve;
}

/// Motion over t*, normalised as in Wetter (2016), figures 4.5 and 4.6. NaN or infinite without
/// friction.
struct MotionCurves {
    report::Curve displacement;  ///< (x - x_s)/(mu kappa4)
    report::Curve z;             ///< over the static displacement
    report::Curve phi;           ///< over mu kappa3 kappa4
    report::Curve force;         ///< f_s/(mu kappa4), in the prism over sqrt(2)
};

MotionCurves motion_curves(const Machine& machine, std::span<const Snapshot> snapshots);

/// A dashed line at a place of the first axis, from 0 to `top`.
report::Curve upright(const std::string& name, double place, double top,
                      std::optional<int> colour = {});

/// The end of the run that figures show: whole periods of a limit cycle, some swings otherwise.
std::span<const Snapshot> last_swings(const Walk& walk);

/// Time between two snapshots of the end of the run; NaN for fewer than two.
double sampling_interval(const Walk& walk);

/// Of figures over normalised time.
inline const std::string time_label = "time t* = t - t_0 [√(m/k_x)]";

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

/// Of more spots single ones are neither drawn nor told.
inline constexpr std::size_t most_spots = 4;

/// Statistics of a contact spot; their errors are half widths of 95 % intervals from the scatter
/// over the run, NaN on a limit cycle, which has none.
struct SpotStatistics {
    report::WithError stick_time;   ///< share of time
    report::WithError correlation;  ///< of velocity and normal deflection
};

/// Of each spot, left to right, after the transient; empty where there are none.
std::vector<SpotStatistics> spot_statistics(const Walk& walk);

}  // namespace tricontact::walking
