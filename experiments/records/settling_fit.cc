#include "experiments/records/settling_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "contact/base/special_values.h"

namespace tricontact::experiments {

namespace {

constexpr int n_ratios = 95;  // of the grid of q, from 0 in steps of 0.01

/// Fit for given q, linear in the rest.
struct Slice {
    double ratio = 0;
    statistics::Fit fit;
};

std::vector<Slice> slices(const std::vector<double>& shift, bool ratchets) {
    std::vector<Slice> all;
    std::vector<double> ones(shift.size(), 1.), count(shift.size());
    for (std::size_t n = 0; n < shift.size(); ++n) count[n] = static_cast<double>(n);
    for (int i = 0; i <= n_ratios; ++i) {
        const double q = 0.01 * i;
        std::vector<double> transient(shift.size());
        for (std::size_t n = 0; n < shift.size(); ++n) transient[n] = -std::pow(q, count[n]);
        std::vector<std::vector<double>> columns{ones, transient};
        if (ratchets) columns.push_back(count);
        all.push_back({q, statistics::fit_linear(columns, shift)});
    }
    return all;
}

const Slice& best_of(const std::vector<Slice>& all) {
    return *std::ranges::min_element(all, {},
                                     [](const Slice& s) { return s.fit.residual_sum_of_squares; });
}

// A fit's variances over that of an observation.
double unit_variance(const statistics::Fit& fit, std::size_t k) {
    const double variance = fit.residual_standard_deviation * fit.residual_standard_deviation;
    return variance > 0 ? fit.covariance[k][k] / variance : 0;
}

// q is a parameter too: one degree of freedom less than of a slice.
Estimate profile(const std::vector<Slice>& all, std::size_t k, double confidence) {
    const Slice& best = best_of(all);
    const int freedom = best.fit.degrees_of_freedom - 1;
    const double t = statistics::student_t(confidence, freedom);
    const double least = best.fit.residual_sum_of_squares;
    const double most = least * (1 + t * t / freedom);
    Estimate e{best.fit.parameters[k].value, 0, contact::infinity, -contact::infinity};
    for (const Slice& slice : all) {
        if (slice.fit.residual_sum_of_squares > most) continue;
        const double left = most - slice.fit.residual_sum_of_squares;
        const double half = std::sqrt(left * unit_variance(slice.fit, k));
        e.low = std::min(e.low, slice.fit.parameters[k].value - half);
        e.high = std::max(e.high, slice.fit.parameters[k].value + half);
    }
    e.standard_error = (e.high - e.low) / (2 * t);
    return e;
}

}  // namespace

SettlingFit fit_settling(const std::vector<double>& shift, double confidence) {
    if (shift.size() < fewest_periods + 1)
        throw std::invalid_argument("a transient and ratcheting need five periods");
    // Three parameters and two degrees of freedom need five values.
    const std::size_t late = shift.size() >= 9 ? (shift.size() - 1) / 2 : 0;
    const std::vector<double> second_half(shift.begin() + static_cast<std::ptrdiff_t>(late),
                                          shift.end());
    const auto ratcheting = slices(shift, true), settling = slices(second_half, false);
    const Slice& best = best_of(ratcheting);
    SettlingFit result;
    result.increment = profile(ratcheting, 2, confidence);
    result.settled = profile(settling, 0, confidence);
    result.ratio = best.ratio;
    result.fitted = best.fit.fitted;
    const int freedom = best.fit.degrees_of_freedom - 1;  // N + 1 - 4
    result.residual_deviation = std::sqrt(best.fit.residual_sum_of_squares / freedom);
    return result;
}

statistics::Fit fit_polynomial(const std::vector<double>& x, const std::vector<double>& y,
                               int degree, double confidence) {
    std::vector<std::vector<double>> powers{std::vector<double>(x.size(), 1.)};
    for (int power = 1; power <= degree; ++power) {
        powers.push_back(powers.back());
        std::ranges::transform(x, powers.back(), powers.back().begin(), std::multiplies());
    }
    return statistics::fit_linear(powers, y, {.confidence = confidence});
}

Estimate normalised_curvature(const std::vector<double>& time, const std::vector<double>& shift,
                              double confidence) {
    const double rise = shift.back() - shift.front(), duration = time.back() - time.front();
    std::vector<double> t, u;
    for (std::size_t i = 0; i < time.size(); ++i) {
        t.push_back((time[i] - time.front()) / duration);
        u.push_back((shift[i] - shift.front()) / rise);
    }
    if (rise == 0)
        return {contact::undefined, contact::undefined, contact::undefined, contact::undefined};
    Estimate e = fit_polynomial(t, u, 2, confidence).parameters[2];
    for (double* value : {&e.value, &e.standard_error, &e.low, &e.high}) *value *= 2;
    return e;
}

}  // namespace tricontact::experiments
