#include "statistics/initial_sequence.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace tricontact::statistics {
namespace {

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

double autocovariance(std::span<const double> values, double mean, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < values.size(); ++i)
        sum += (values[i] - mean) * (values[i - lag] - mean);
    return sum / static_cast<double>(values.size());
}

}  // namespace

double independent_values(std::span<const double> values) {
    const double mean = mean_of(values), n = static_cast<double>(values.size()),
                 variance = autocovariance(values, mean, 0);
    double sum = -variance, least = std::numeric_limits<double>::infinity();
    for (std::size_t lag = 0; lag + 1 < values.size(); lag += 2) {
        const double pair =
            autocovariance(values, mean, lag) + autocovariance(values, mean, lag + 1);
        if (!(pair > 0)) break;
        least = std::min(least, pair);
        sum += 2 * least;
    }
    return sum > variance ? std::max(2., n * variance / sum) : n;
}

Mean initial_sequence_mean(std::span<const double> values) {
    const double mean = mean_of(values), freedom = independent_values(values) - 1;
    const double student = boost::math::quantile(boost::math::students_t(freedom), 0.975);
    return {mean, student * std::sqrt(autocovariance(values, mean, 0) / freedom)};
}

}  // namespace tricontact::statistics
