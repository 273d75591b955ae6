#include "walking/run/fall_risk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "statistics/stationarity.h"

namespace tricontact::walking {
namespace {

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

/// Where the mean of the values is after so many times their number more, if it goes on as from
/// their first to their last third.
double continued(std::span<const double> values, double times) {
    const statistics::Thirds<double> thirds(values);
    const double last = mean_of(thirds.last), first = mean_of(thirds.first);
    const double thirds_apart = static_cast<double>(values.size() - thirds.last.size()) /
                                static_cast<double>(values.size());
    return last + times * (last - first) / thirds_apart;
}

}  // namespace

double expected_falls(const Machine& machine, std::span<const WalkWindow> windows, double times) {
    std::vector<double> rotations;
    for (const WalkWindow& window : windows)
        rotations.push_back(std::max(-window.sums.phi_min, window.sums.phi_max) /
                            tilting_limit(machine));
    if (rotations.size() < 6) return 0;
    if (!statistics::stationary(rotations) && continued(rotations, times) >= 1)
        return std::numeric_limits<double>::infinity();
    std::ranges::sort(rotations);
    const auto tail = std::span(rotations).subspan(rotations.size() / 2);
    const double median = tail.front(), excess = mean_of(tail) - median;
    if (!(excess > 0)) return 0;
    return times * static_cast<double>(tail.size()) * std::exp(-(1 - median) / excess);
}

}  // namespace tricontact::walking
