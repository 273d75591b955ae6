#include "comparisons/shakedown/limit_curve.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace tricontact::comparisons {

namespace {

/// Below it the limit is nearly 1, or 0, whatever k is.
constexpr double least_weight = 0.01;

double weight_of(double w) {
    return w * (1 - w) * (1 + w);
}

std::vector<LimitPoint> usable(std::vector<LimitPoint> limits) {
    std::erase_if(limits,
                  [](const LimitPoint& p) { return weight_of(p.amplitude_ratio) < least_weight; });
    std::sort(limits.begin(), limits.end(), [](const LimitPoint& a, const LimitPoint& b) {
        return a.amplitude_ratio < b.amplitude_ratio;
    });
    return limits;
}

}  // namespace

std::optional<FittedForm> fit_limit(const std::vector<LimitPoint>& limits, double confidence) {
    std::vector<double> column, observed, offset;
    for (const LimitPoint& p : usable(limits)) {
        column.push_back(-weight_of(p.amplitude_ratio));
        observed.push_back(p.limit.value);
        offset.push_back(1 - std::pow(p.amplitude_ratio, 3));
    }
    return fit_form("f_T,lim = 1 - k w (1 - w^2) - w^3", {"k"}, {column}, observed, offset,
                    confidence, 2);
}

}  // namespace tricontact::comparisons
