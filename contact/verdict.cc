#include "contact/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tricontact::contact {

namespace {

constexpr double negligible_shift = 1e-7;        // per period, over U_max
constexpr double negligible_dissipation = 1e-6;  // per period, over mu F_N U_max
// Still to come, over U_max: where the solver's noise spoils Aitken's limit, but nobody cares.
constexpr double negligible_remainder = 1e-5;

/// Increments of the shift, positive in the direction of the last one.
std::vector<double> increments(const Evolution& evolution) {
    std::vector<double> result;
    double last = evolution.static_shift_ratio;
    for (const double u : evolution.shift_ratio) {
        result.push_back(u - last);
        last = u;
    }
    if (!result.empty() && result.back() < 0)
        for (double& value : result) value = -value;
    return result;
}

/// Limit of the increments over the last of them, by Aitken's delta-squared from three.
double relative_limit(double d1, double d2, double d3) {
    const double change = d3 - d2, second = (d3 - d2) - (d2 - d1);
    if (std::abs(change) < 1e-3 * d3 || second == 0) return 1;
    return 1 - change * change / (second * d3);
}

/// The end of the increments as seen from one of them and those one and two strides before it.
struct Tail {
    double change;  ///< factor from the middle one of the three to the last
    double ratio;   ///< the same per period
    double limit;   ///< see relative_limit
};

Tail tail_of(const std::vector<double>& d, std::size_t last, std::size_t stride) {
    const double change = d[last] / d[last - stride];
    return {change, std::pow(change, 1.0 / static_cast<double>(stride)),
            relative_limit(d[last - 2 * stride], d[last - stride], d[last])};
}

bool decays(double last, const Tail& now, const Tail& before) {
    const bool steady =
        std::max(now.ratio, before.ratio) < 0.95 && std::abs(now.ratio - before.ratio) < 0.05;
    const bool to_zero = std::max(std::abs(now.limit), std::abs(before.limit)) < 0.1;
    const double to_come = last * now.ratio / (1 - now.ratio);
    return steady && ((to_zero && to_come < 1e-3) || to_come < negligible_remainder);
}

bool persists(const Tail& now, const Tail& before) {
    const bool constant = std::max(std::abs(now.change - 1), std::abs(before.change - 1)) < 0.01;
    return constant || std::min(now.limit, before.limit) >= 0.6;
}

}  // namespace

const char* name_of(State state) {
    switch (state) {
        case State::shakedown:
            return "shakedown";
        case State::cyclic_slip:
            return "cyclic-slip";
        case State::ratcheting:
            return "ratcheting";
        default:
            return "undecided";
    }
}

double last_increment(const Evolution& evolution) {
    return evolution.shift_ratio.empty() ? 0 : std::abs(increments(evolution).back());
}

bool has_settled(const Evolution& evolution) {
    return !evolution.shift_ratio.empty() && last_increment(evolution) <= negligible_shift &&
           std::abs(evolution.dissipation_ratio.back()) <= negligible_dissipation;
}

State judge(const Evolution& evolution) {
    if (has_settled(evolution)) return State::shakedown;
    const std::vector<double> d = increments(evolution);
    const std::size_t n = d.size();
    if (n < 4) return State::undecided;
    const std::size_t stride = std::max<std::size_t>(1, n / 6);
    const auto first = d.end() - 1 - 3 * static_cast<std::ptrdiff_t>(stride);
    if (std::any_of(first, d.end(), [](double value) { return value < negligible_shift; }))
        return State::undecided;
    const Tail now = tail_of(d, n - 1, stride), before = tail_of(d, n - 1 - stride, stride);
    if (persists(now, before)) return State::ratcheting;
    return decays(d[n - 1], now, before) ? State::shakedown : State::undecided;
}

}  // namespace tricontact::contact
