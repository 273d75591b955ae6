#include "walking/report/spot_statistics.h"

#include <cmath>
#include <limits>

#include "contact/special_values.h"
#include "statistics/initial_sequence.h"

namespace tricontact::walking {

namespace {

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

std::vector<SpotStatistics> spot_statistics(const WalkReport& report) {
    const auto stick_time = [](const SpotSums& spot, std::int64_t steps) {
        return static_cast<double>(spot.sticking) / static_cast<double>(steps);
    };
    std::vector<SpotStatistics> result;
    const std::vector<WalkResult::Spot>& spots = report.walk.result.spots;
    for (std::size_t i = 0; i < spots.size(); ++i)
        result.push_back({static_cast<int>(i + 1),
                          {spots[i].stick_time, error_of(report.walk, i, stick_time)},
                          {spots[i].correlation, error_of(report.walk, i, correlation)}});
    return result;
}

}  // namespace tricontact::walking
