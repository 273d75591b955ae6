#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "experiments/records/drive_timeline.h"

namespace tricontact::experiments {

namespace {

constexpr int samples_per_period = 200;      // of the grid, in the longest period possible
constexpr double nearly_equal = 0.8;         // of the highest peak
constexpr double least_correlation = 0.3;    // noise alone has 1/sqrt(samples), below 0.07
constexpr double smoothing = 1. / 20;        // of a period: speeds are means over it
constexpr double refined_within = 0.5 / 20;  // of the first estimate

constexpr const char* remedy = "record the drive, or give drive.period";

/// Mean speeds on a regular grid, their mean subtracted.
std::vector<double> speeds_of(const Record& record, double start, double step) {
    std::vector<double> shift, speeds;
    std::size_t k = 0;
    for (double t = start; t <= record.time.back(); t += step) {
        while (k + 2 < record.time.size() && record.time[k + 1] < t) ++k;
        const double part = (t - record.time[k]) / (record.time[k + 1] - record.time[k]);
        shift.push_back(record.shift[k] + part * (record.shift[k + 1] - record.shift[k]));
    }
    const auto over = static_cast<std::size_t>(samples_per_period * smoothing);
    double mean = 0;
    for (std::size_t i = over; i < shift.size(); ++i) {
        speeds.push_back(shift[i] - shift[i - over]);
        mean += speeds.back();
    }
    for (double& v : speeds) v -= mean / static_cast<double>(speeds.size());
    return speeds;
}

// Over the overlap, 1 for a periodic signal at its period.
double autocorrelation(const std::vector<double>& signal, std::size_t lag) {
    double product = 0, first = 0, second = 0;
    for (std::size_t i = lag; i < signal.size(); ++i) {
        product += signal[i] * signal[i - lag];
        first += signal[i] * signal[i];
        second += signal[i - lag] * signal[i - lag];
    }
    return first > 0 && second > 0 ? product / std::sqrt(first * second) : 0;
}

}  // namespace

double shift_period(const Record& record, double start, int periods) {
    const double longest = (record.time.back() - start) / periods;
    if (!(longest > 0) || start < record.time.front())
        refuse_record(record, "the rolling does not begin within the record", remedy);
    const double step = longest / samples_per_period;
    const std::vector<double> speeds = speeds_of(record, start, step);
    std::vector<double> rho;
    for (std::size_t lag = 0; lag <= samples_per_period + 1; ++lag)
        rho.push_back(autocorrelation(speeds, lag));
    double highest = 0;
    std::vector<std::size_t> peaks;
    for (std::size_t lag = samples_per_period / 8; lag + 1 < rho.size(); ++lag) {
        if (rho[lag] < rho[lag - 1] || rho[lag] < rho[lag + 1]) continue;
        peaks.push_back(lag);
        highest = std::max(highest, rho[lag]);
    }
    if (highest < least_correlation)
        refuse_record(record, "no period stands out in the shift", remedy);
    std::erase_if(peaks, [&](std::size_t lag) { return rho[lag] < nearly_equal * highest; });
    const double first = static_cast<double>(peaks.back()) * step;

    const auto loss = [&](double period) {
        double sum = 0;
        for (int k = 1; k <= std::max(1, periods / 2); ++k) {
            const double lag = k * period / step, part = lag - std::floor(lag);
            const auto whole = static_cast<std::size_t>(lag);
            sum -= (1 - part) * autocorrelation(speeds, whole) +
                   part * autocorrelation(speeds, whole + 1);
        }
        return sum;
    };
    constexpr int bits = 24;  // of the minimum's place: 1e-7, beyond what noise leaves
    return boost::math::tools::brent_find_minima(loss, first * (1 - refined_within),
                                                 first * (1 + refined_within), bits)
        .first;
}

}  // namespace tricontact::experiments
