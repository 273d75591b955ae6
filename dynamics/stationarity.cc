#include "dynamics/stationarity.h"

#include <cmath>
#include <limits>

#include "dynamics/block_bootstrap.h"

namespace tricontact::dynamics {

std::size_t transient_values(std::span<const double> values) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity(), sum = 0, squares = 0;
    for (std::size_t left = values.size(); left-- > 0;) {
        sum += values[left];
        squares += values[left] * values[left];
        const double n = static_cast<double>(values.size() - left);
        const double error = (squares - sum * sum / n) / (n * n);
        if (2 * left > values.size() || error > least) continue;
        least = error;
        best = left;
    }
    return best;
}

bool stationary(std::span<const double> values) {
    const std::size_t third = values.size() / 3;
    if (third < 2) return false;
    const Mean before = block_bootstrap_mean(values.first(third)),
               after = block_bootstrap_mean(values.last(third));
    return std::abs(after.value - before.value) <= 1.5 * std::hypot(before.error, after.error);
}

}  // namespace tricontact::dynamics
