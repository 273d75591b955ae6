#include "experiments/records/record_hum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"
#include "statistics/estimate.h"
#include "statistics/spectrum.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t first_line = 12;  // of the spectrum
constexpr std::size_t own_lines = 4;    // a line's neighbours, which the Hann window gives to it
constexpr std::size_t most_beside = 40, fewest_beside = 10;
constexpr double reach_of_background = 1.6;  // times the frequency
constexpr double false_alarms = 1e-3;

/// Mean power of noise about line i, and of how many independent values.
struct Background {
    double power = 0, values = 0;
};

Background background_of(const std::vector<double>& amplitudes, std::size_t i) {
    const auto part = [&](double factor) {
        return static_cast<std::size_t>(factor * static_cast<double>(i));
    };
    const std::size_t low = std::max(part(1 / reach_of_background), i - std::min(i, most_beside)),
                      high = std::min(
                          {part(reach_of_background), i + most_beside, amplitudes.size() - 1});
    std::vector<double> powers;
    for (std::size_t k = low; k <= high; ++k)
        if (k + own_lines <= i || k >= i + own_lines)
            powers.push_back(amplitudes[k] * amplitudes[k]);
    if (powers.size() < fewest_beside) return {};
    const double n = static_cast<double>(powers.size());
    // Powers of noise are exponential; neighbours under a Hann window share half.
    return {statistics::median(std::move(powers)) / std::log(2.), n / 2};
}

}  // namespace

void find_hum(const std::vector<double>& residuals, double interval, double resolution,
              RecordFindings& findings) {
    if (residuals.size() < 4 * first_line) return;
    const auto spectrum = statistics::spectrum(residuals, interval);
    const auto& a = spectrum.amplitudes;
    std::size_t found = 0;
    for (std::size_t i = first_line; i < a.size(); ++i) {
        const Background noise = background_of(a, i);
        if (noise.power <= 0) continue;
        // Beside a mean that is estimated from so many values: Fisher's F in place of exp(-x).
        const double lines = static_cast<double>(a.size());
        const double least =
            noise.values * (std::pow(lines / false_alarms, 1 / noise.values) - 1) * noise.power;
        if (a[i] * a[i] > least && a[i] > resolution && (found == 0 || a[i] > a[found])) found = i;
    }
    if (found == 0) return;
    findings.push_back(
        {RecordFinding::Kind::hum,
         fmt::format("the shift hums at {} Hz by {} µm while it rests (what is faster than half "
                     "the sampling rate is seen at a lower frequency): filter the signal before "
                     "it is sampled",
                     report::significant(static_cast<double>(found) * spectrum.resolution, 3),
                     report::significant(1e6 * a[found], 2))});
}

}  // namespace tricontact::experiments
