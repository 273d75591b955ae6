#include "walking/report/vibration.h"

#include <cmath>

#include "statistics/initial_sequence.h"
#include "statistics/spectrum.h"
#include "walking/report/motion_series.h"

namespace tricontact::walking {

namespace {

// Of the recorded end, some fifteen swings each: their scatter is the error.
constexpr int n_parts = 8;
constexpr std::size_t fewest = n_parts * 100;

/// Every n-th place of the window, so that neighbours differ and resampling is quick.
std::vector<double> above(const std::vector<double>& variances) {
    constexpr std::size_t enough = 500;
    const std::size_t stride = 1 + variances.size() / enough;
    std::vector<double> result;
    for (std::size_t i = 0; i < variances.size(); i += stride)
        result.push_back(variances[i] > instability_threshold ? 1 : 0);
    return result;
}

void find_instability(const std::vector<double>& forces, Vibration& vibration) {
    constexpr double periods = 10;
    vibration.window = periods / vibration.characteristic.frequency;
    const double length = std::round(vibration.window / vibration.interval);
    if (length >= 2 && length < static_cast<double>(forces.size()))
        vibration.variances =
            statistics::running_variance(forces, static_cast<std::size_t>(length));
    vibration.instability = statistics::share_above(vibration.variances, instability_threshold);
}

}  // namespace

std::optional<Vibration> vibration_of(const Machine& machine, const Walk& walk) {
    if (walk.tail.size() < fewest) return std::nullopt;
    const std::vector<double> forces = motion_series(machine, walk.tail).force;
    Vibration vibration;
    vibration.interval = sampling_interval(walk);
    vibration.spectrum = statistics::mean_spectrum(forces, vibration.interval, n_parts);
    vibration.characteristic =
        statistics::characteristic_frequency(forces, vibration.interval, n_parts);
    vibration.free_flight = free_flight_frequency(machine.kappas);
    find_instability(forces, vibration);
    return vibration;
}

double instability_error(const Vibration& vibration) {
    const std::vector<double> places = above(vibration.variances);
    return places.size() < 2 ? std::nan("") : statistics::initial_sequence_mean(places).error;
}

}  // namespace tricontact::walking
