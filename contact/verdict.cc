#include "contact/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tricontact::contact {

namespace {

constexpr double negligible_shift = 1e-7;        // per period, over U_max
constexpr double negligible_dissipation = 1e-6;  // per period, over mu F_N U_max

std::vector<double> increments(const Evolution& evolution) {
    std::vector<double> result;
    double last = evolution.static_shift_ratio;
    for (const double u : evolution.shift_ratio) {
        result.push_back(u - last);
        last = u;
    }
    return result;
}

/// Limit of the increments over the last of them, by Aitken's delta-squared from three.
double relative_limit(double d1, double d2, double d3) {
    const double change = d3 - d2, second = (d3 - d2) - (d2 - d1);
    if (std::abs(change) < 1e-3 * d3 || second == 0) return 1;
    return 1 - change * change / (second * d3);
}

/// The last increments, and what the two last triples of them say.
struct Tail {
    double last, ratio, previous_ratio, limit, previous_limit;
};

Tail tail_of(const std::vector<double>& d) {
    const std::size_t n = d.size();
    return {.last = d[n - 1],
            .ratio = d[n - 1] / d[n - 2],
            .previous_ratio = d[n - 2] / d[n - 3],
            .limit = relative_limit(d[n - 3], d[n - 2], d[n - 1]),
            .previous_limit = relative_limit(d[n - 4], d[n - 3], d[n - 2])};
}

bool decays(const Tail& t) {
    const bool steady =
        std::max(t.ratio, t.previous_ratio) < 0.95 && std::abs(t.ratio - t.previous_ratio) < 0.05;
    const bool to_zero = std::max(std::abs(t.limit), std::abs(t.previous_limit)) < 0.1;
    return steady && to_zero && t.last * t.ratio / (1 - t.ratio) < 1e-3;
}

bool persists(const Tail& t) {
    const bool constant = std::max(std::abs(t.ratio - 1), std::abs(t.previous_ratio - 1)) < 0.01;
    return constant || std::min(t.limit, t.previous_limit) >= 0.6;
}

}  // namespace

const char* name_of(State state) {
    switch (state) {
        case State::shakedown:
            return "shakedown";
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
    if (std::any_of(d.end() - 4, d.end(), [](double value) { return value < negligible_shift; }))
        return State::undecided;
    const Tail tail = tail_of(d);
    if (persists(tail)) return State::ratcheting;
    return decays(tail) ? State::shakedown : State::undecided;
}

}  // namespace tricontact::contact
