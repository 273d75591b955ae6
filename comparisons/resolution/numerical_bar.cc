#include "comparisons/resolution/numerical_bar.h"

#include <cmath>

#include "comparisons/resolution/refinement.h"

namespace tricontact::comparisons {

namespace {

/// Value at infinitely many steps, linear in 1/n.
double extrapolated(int n1, double v1, int n2, double v2) {
    return v2 + (v2 - v1) * n1 / static_cast<double>(n2 - n1);
}

}  // namespace

bool differs(const Computed& a, const Computed& b) {
    return std::abs(a.value - b.value) > a.error + b.error;  // false with NaN
}

Computed value_of_levels(const std::vector<double>& sizes, const std::vector<double>& values) {
    const std::size_t n = values.size();
    if (n == 1) return {values.front()};
    if (n == 2) {
        const double to_come = std::abs(values[1] - values[0]) / (sizes[0] / sizes[1] - 1);
        return {values[1], safety_factor * to_come};
    }
    const LimitEstimate limit = estimate_limit(sizes, values);
    return {limit.value, limit.error};
}

Computed value_of_steps(const std::vector<int>& steps, const std::vector<double>& values) {
    const std::size_t n = values.size();
    if (n == 1) return {values.front()};
    const double last = extrapolated(steps[n - 2], values[n - 2], steps[n - 1], values[n - 1]);
    if (n == 2) return {last, std::abs(last - values[1]) / 2};
    const double before = extrapolated(steps[n - 3], values[n - 3], steps[n - 2], values[n - 2]);
    return {last, std::abs(last - before)};
}

}  // namespace tricontact::comparisons
