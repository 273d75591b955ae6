#include "experiments/records/drive_delay.h"

#include <cmath>
#include <numbers>

#include "statistics/regression.h"

namespace tricontact::experiments {

bool DriveDelay::is_seen(double period) const {
    return std::abs(time) > 3 * standard_error && std::abs(time) > period / 50;
}

std::optional<DriveDelay> drive_delay(const std::vector<double>& time,
                                      const std::vector<double>& shift, double begin,
                                      double period) {
    using std::numbers::pi;
    constexpr std::size_t n_columns = 6;
    std::vector<std::vector<double>> columns(n_columns);
    for (const double t : time) {
        const double angle = 2 * pi * (t - begin) / period;
        const double row[n_columns] = {1,
                                       (t - begin) / period,
                                       std::sin(angle),
                                       std::cos(angle),
                                       std::sin(2 * angle),
                                       std::cos(2 * angle)};
        for (std::size_t c = 0; c < n_columns; ++c) columns[c].push_back(row[c]);
    }
    const statistics::Fit fit = statistics::fit_linear(columns, shift);
    const auto &in_phase = fit.parameters[2], &behind = fit.parameters[3];
    const double amplitude = std::hypot(in_phase.value, behind.value),
                 error = std::hypot(in_phase.standard_error, behind.standard_error);
    if (amplitude <= 6 * error) return {};
    const double lag = std::atan(-behind.value / in_phase.value);  // either sign follows the drive
    const double triangle = amplitude * pi * pi / 8;  // height of the wave with this harmonic
    DriveDelay delay{.time = lag * period / (2 * pi),
                     .standard_error = error / amplitude * period / (2 * pi)};
    delay.shift_upright = std::abs(4 * triangle * delay.time / period);
    return delay;
}

}  // namespace tricontact::experiments
