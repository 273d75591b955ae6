#include "statistics/error_propagation.h"

#include <algorithm>
#include <boost/math/differentiation/finite_difference.hpp>
#include <cmath>
#include <stdexcept>

namespace tricontact::statistics {

namespace {

// (df/dx_i) sigma_i at the values x. The difference formula knows no scale: its variable is
// (x_i - value)/scale, so that its steps (at most 0.9 % of it) stay within one standard error.
double contribution(const Quantity& f, std::vector<double> x, std::size_t i, double sigma) {
    const double value = x[i], scale = std::min(std::max(std::abs(value), sigma), 100 * sigma);
    const auto along = [&](double t) {
        x[i] = value + t * scale;
        return f(x);
    };
    return boost::math::differentiation::finite_difference_derivative(along, 0.) / scale * sigma;
}

void check(const std::vector<Estimate>& quantities,
           const std::vector<std::vector<double>>& correlation) {
    const auto n = quantities.size();
    if (!std::ranges::all_of(quantities, [](const Estimate& q) { return q.standard_error >= 0; }))
        throw std::invalid_argument("a standard error must not be negative");
    if (!correlation.empty() &&
        (correlation.size() != n ||
         !std::ranges::all_of(correlation, [n](const auto& row) { return row.size() == n; })))
        throw std::invalid_argument("correlations need one row and column per quantity");
}

}  // namespace

Propagated propagate(const Quantity& f, const std::vector<Estimate>& quantities,
                     const std::vector<std::vector<double>>& correlation) {
    check(quantities, correlation);
    std::vector<double> x;
    for (const Estimate& q : quantities) x.push_back(q.value);
    Propagated p;
    p.result.value = f(x);
    double variance = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double sigma = quantities[i].standard_error;
        p.contributions.push_back(sigma == 0 ? 0 : contribution(f, x, i, sigma));
    }
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j) {
            const double r = correlation.empty() ? (i == j ? 1 : 0) : correlation[i][j];
            variance += p.contributions[i] * r * p.contributions[j];
        }
    // Fully correlated quantities that cancel leave rounding of either sign.
    p.result.standard_error = std::sqrt(std::max(0., variance));
    if (!std::isfinite(p.result.value) || !std::isfinite(variance))
        throw std::domain_error("errors cannot be propagated where the function is not smooth");
    return p;
}

}  // namespace tricontact::statistics
