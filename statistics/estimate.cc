#include "statistics/estimate.h"

#include <gsl/gsl_cdf.h>

#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "contact/base/special_values.h"

namespace tricontact::statistics {

void Estimate::widen(double other_error, double other_half_width) {
    low = value - std::hypot(value - low, other_half_width);
    high = value + std::hypot(high - value, other_half_width);
    standard_error = std::hypot(standard_error, other_error);
}

Estimate with_interval(double value, double standard_error, double factor) {
    const double half = factor * standard_error;
    return {value, standard_error, value - half, value + half};
}

Estimate mean_of(const std::vector<double>& values, double confidence) {
    if (values.size() < 2)
        throw std::invalid_argument("the scatter of repeats shows from two values on");
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.) / n;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return with_interval(mean, std::sqrt(squares / (n - 1) / n),
                         student_t(confidence, static_cast<int>(values.size()) - 1));
}

double median(std::vector<double> values) {
    return values.empty() ? contact::undefined : boost::math::statistics::median(values);
}

bool differ(const Estimate& a, const Estimate& b) {
    return a.low > b.high || b.low > a.high;
}

double student_t(double confidence, int degrees_of_freedom) {
    return gsl_cdf_tdist_Pinv((1 + confidence) / 2, degrees_of_freedom);
}

double normal_quantile(double confidence) {
    return gsl_cdf_ugaussian_Pinv((1 + confidence) / 2);
}

}  // namespace tricontact::statistics
