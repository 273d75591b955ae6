#include "experiments/records/repeats.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tricontact::experiments {

statistics::Estimate mean_of(const std::vector<double>& values, double confidence) {
    if (values.size() < 2)
        throw std::invalid_argument("the scatter of repeats shows from two values on");
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.) / n;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double error = std::sqrt(squares / (n - 1) / n);
    const double half =
        statistics::student_t(confidence, static_cast<int>(values.size()) - 1) * error;
    return {mean, error, mean - half, mean + half};
}

bool differ(const statistics::Estimate& a, const statistics::Estimate& b) {
    return a.low > b.high || b.low > a.high;
}

}  // namespace tricontact::experiments
