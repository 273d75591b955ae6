#include "comparisons/resolution/refinement.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/base/root.h"

namespace tricontact::comparisons {

namespace {

constexpr double least_searched = 0.01, largest_searched = 20;

/// (h1^p - h2^p)/(h2^p - h3^p), increasing in p.
double ratio_of_changes(std::span<const double, 3> h, double p) {
    const double a = std::pow(h[0] / h[1], p), b = std::pow(h[2] / h[1], p);
    return (a - 1) / (1 - b);
}

double spread(std::span<const double> values) {
    const auto [low, high] = std::ranges::minmax_element(values);
    return *high - *low;
}

/// v3 + this is the limit of v + C h^p through the last two values.
double rest(std::span<const double, 3> h, std::span<const double, 3> v, double p) {
    return (v[2] - v[1]) / (std::pow(h[1] / h[2], p) - 1);
}

/// Value at infinitely many steps, linear in 1/n.
double extrapolated(const std::pair<int, double>& a, const std::pair<int, double>& b) {
    return b.second + (b.second - a.second) * a.first / static_cast<double>(b.first - a.first);
}

/// Order p with (h1^p - h2^p)/(h2^p - h3^p) = (v1 - v2)/(v2 - v3) for h1 > h2 > h3 > 0; empty where
/// there is none in [0.01, 20].
std::optional<double> observed_order(std::span<const double, 3> sizes,
                                     std::span<const double, 3> values) {
    const double first = values[0] - values[1], second = values[1] - values[2];
    if (!(first * second > 0)) return {};
    const double ratio = first / second;
    const auto excess = [&](double p) { return ratio_of_changes(sizes, p) - ratio; };
    if (!(excess(least_searched) < 0) || !(excess(largest_searched) > 0)) return {};
    return contact::bracketed_root(excess, least_searched, largest_searched, 48);
}

}  // namespace

const char* name_of(Convergence convergence) {
    constexpr const char* names[] = {"ordered", "unchanged", "oscillating", "irregular",
                                     "no order"};
    return names[static_cast<int>(convergence)];
}

LimitEstimate estimate_limit(std::span<const double> sizes, std::span<const double> values,
                             double noise, double trusted_order) {
    if (sizes.size() < 3 || sizes.size() != values.size() ||
        std::ranges::adjacent_find(sizes, std::less_equal<>()) != sizes.end() ||
        !(sizes.back() > 0))
        throw std::logic_error("refinement: needs three levels of decreasing size");
    const auto h = sizes.last<3>();
    const auto v = values.last<3>();
    const double first = v[1] - v[0], second = v[2] - v[1];
    LimitEstimate result;
    result.value = v[2];
    result.error = std::max(noise, spread(v));
    if (std::max(std::abs(first), std::abs(second)) <= noise) {
        result.convergence = Convergence::unchanged;
        return result;
    }
    if (first * second < 0) {
        result.convergence = Convergence::oscillating;
        return result;
    }
    result.order = observed_order(h, v);
    if (!result.order || *result.order < least_order || *result.order > largest_order)
        return result;
    result.convergence = Convergence::ordered;
    result.value = v[2] + rest(h, v, *result.order);
    const double trusted = std::min(*result.order, trusted_order);
    result.error = std::max(noise, safety_factor * std::abs(rest(h, v, trusted)));
    return result;
}

LimitEstimate estimate_unordered(std::span<const double> values, double noise) {
    if (values.size() < 3) throw std::logic_error("refinement: needs three levels");
    const auto v = values.last<3>();
    const bool changes = spread(v) > noise;
    return {.convergence = changes ? Convergence::unordered : Convergence::unchanged,
            .order = {},
            .value = v[2],
            .error = std::max(noise, safety_factor * spread(v))};
}

std::optional<double> RefinedQuantity::wide_change() const {
    if (!wide || values.size() < 2 || values[values.size() - 2] == 0) return {};
    return *wide / values[values.size() - 2] - 1;
}

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

Computed value_of_steps(const std::map<int, double>& values) {
    const std::vector<std::pair<int, double>> at(values.begin(), values.end());
    const std::size_t n = at.size();
    if (n == 1) return {at[0].second};
    const double last = extrapolated(at[n - 2], at[n - 1]);
    if (n == 2) return {last, std::abs(last - at[1].second) / 2};
    return {last, std::abs(last - extrapolated(at[n - 3], at[n - 2]))};
}

}  // namespace tricontact::comparisons
