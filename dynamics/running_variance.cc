#include "dynamics/running_variance.h"

#include <algorithm>
#include <limits>

namespace tricontact::dynamics {

std::vector<double> running_variance(std::span<const double> values, std::size_t length) {
    std::vector<double> result;
    if (length == 0 || values.size() < length) return result;
    const double n = static_cast<double>(length);
    // Welford's update for a window that gains one value and loses another: no difference of great
    // sums, which would swallow a small variance.
    double mean = 0, squares = 0;
    for (std::size_t i = 0; i < length; ++i) {
        const double before = mean;
        mean += (values[i] - mean) / static_cast<double>(i + 1);
        squares += (values[i] - before) * (values[i] - mean);
    }
    result.push_back(squares / n);
    for (std::size_t i = length; i < values.size(); ++i) {
        const double gained = values[i], lost = values[i - length], before = mean;
        mean += (gained - lost) / n;
        squares += (gained - lost) * (gained - mean + lost - before);
        result.push_back(std::max(0., squares) / n);
    }
    return result;
}

double share_above(std::span<const double> variances, double threshold) {
    if (variances.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto above = std::count_if(variances.begin(), variances.end(),
                                     [threshold](double variance) { return variance > threshold; });
    return static_cast<double>(above) / static_cast<double>(variances.size());
}

}  // namespace tricontact::dynamics
