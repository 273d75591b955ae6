#include "walking/run/walk_readings.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "statistics/initial_sequence.h"

namespace tricontact::walking {

namespace {

// Of the recorded end, some fifteen swings each: their scatter is the error.
constexpr int n_parts = 8;
constexpr std::size_t fewest = n_parts * 100;

/// Of the mean over windows after the transient.
template <class Value>
double error_of(const Walk& walk, std::size_t spot, Value value) {
    if (walk.result.regime == Regime::limit_cycle) return contact::undefined;
    std::vector<double> values;
    for (const WalkWindow& window : walk.windows) {
        if (window.begin < walk.result.transient || spot >= window.sums.spots.size()) continue;
        const double each = value(window.sums.spots[spot], window.sums.steps);
        if (std::isfinite(each)) values.push_back(each);  // else the spot never touched
    }
    return values.size() > 1 ? statistics::initial_sequence_mean(values).error : contact::undefined;
}

}  // namespace

MotionCurves motion_curves(const Machine& machine, std::span<const Snapshot> snapshots) {
    const double load = machine.kappas.kappa5 * machine.kappas.kappa4;
    const double rest = static_displacement(machine), sliding = sliding_force(machine);
    const auto curve = [&](const char* name, auto value) {
        return over_time(snapshots, name, [&](const Snapshot& s) { return value(s.motion); });
    };
    return {curve("Δx", [&](const Motion& m) { return (m.x - m.base) / load; }),
            curve("z", [&](const Motion& m) { return m.z / rest; }),
            curve("φ", [&](const Motion& m) { return m.phi / (machine.kappas.kappa3 * load); }),
            curve("f_s", [&](const Motion& m) { return spring_force(machine, m) / sliding; })};
}

report::Curve upright(const std::string& name, double place, double top,
                      std::optional<int> colour) {
    return {.name = name, .x = {place, place}, .y = {0, top}, .theory = true, .colour = colour};
}

double sampling_interval(const Walk& walk) {
    if (walk.tail.size() < 2) return contact::undefined;
    return walk.tail[1].motion.time - walk.tail[0].motion.time;
}

std::span<const Snapshot> last_swings(const Walk& walk) {
    constexpr double shown = 10, without_period = 20;
    const double period = walk.result.period.value_or(0);
    const double length = period > 0 ? period * std::ceil(shown / period) : without_period;
    const double steps = std::round(length / sampling_interval(walk));  // NaN: one snapshot or none
    const std::size_t n = steps >= 0 ? static_cast<std::size_t>(steps) + 1 : walk.tail.size();
    return std::span(walk.tail).last(std::min(n, walk.tail.size()));
}

std::optional<Vibration> vibration_of(const Machine& machine, const Walk& walk) {
    if (walk.tail.size() < fewest) return std::nullopt;
    const std::vector<double> forces = motion_curves(machine, walk.tail).force.y;
    Vibration vibration;
    vibration.interval = sampling_interval(walk);
    vibration.spectrum = statistics::mean_spectrum(forces, vibration.interval, n_parts);
    vibration.characteristic =
        statistics::characteristic_frequency(forces, vibration.interval, n_parts);
    vibration.free_flight = free_flight_frequency(machine.kappas);
    constexpr double periods = 10;
    vibration.window = periods / vibration.characteristic.frequency;
    const double length = std::round(vibration.window / vibration.interval);
    if (length >= 2 && length < static_cast<double>(forces.size()))
        vibration.variances =
            statistics::running_variance(forces, static_cast<std::size_t>(length));
    vibration.instability = statistics::share_above(vibration.variances, instability_threshold);
    return vibration;
}

double instability_error(const Vibration& vibration) {
    // Every n-th place of the window, so that neighbours differ and resampling is quick.
    constexpr std::size_t enough = 500;
    std::vector<double> places;
    for (std::size_t i = 0; i < vibration.variances.size();
         i += 1 + vibration.variances.size() / enough)
        places.push_back(vibration.variances[i] > instability_threshold ? 1 : 0);
    return places.size() < 2 ? std::nan("") : statistics::initial_sequence_mean(places).error;
}

std::vector<SpotStatistics> spot_statistics(const Walk& walk) {
    const auto stick_time = [](const SpotSums& spot, std::int64_t steps) {
        return static_cast<double>(spot.sticking) / static_cast<double>(steps);
    };
    std::vector<SpotStatistics> result;
    const std::vector<WalkResult::Spot>& spots = walk.result.spots;
    for (std::size_t i = 0; i < spots.size(); ++i)
        result.push_back({{spots[i].stick_time, error_of(walk, i, stick_time)},
                          {spots[i].correlation, error_of(walk, i, correlation)}});
    return result;
}

}  // namespace tricontact::walking
