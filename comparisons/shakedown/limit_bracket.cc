#include "comparisons/shakedown/limit_bracket.h"

#include <algorithm>
#include <numeric>

#include "contact/verdict.h"

namespace tricontact::comparisons {

using contact::State;

namespace {

/// An undecided value beyond an end that has moved since is none any more.
void trim(LimitBracket& bracket) {
    auto& band = bracket.undecided;
    if (!band) return;
    if (band->second <= bracket.last_shakedown || band->first >= bracket.first_ratcheting) {
        band.reset();
        return;
    }
    band->first = std::max(band->first, bracket.last_shakedown);
    band->second = std::min(band->second, bracket.first_ratcheting);
}

void note(LimitBracket& bracket, double value, State state) {
    if (contact::settles(state))
        bracket.last_shakedown = value;
    else if (state == State::ratcheting)
        bracket.first_ratcheting = value;
    else if (!bracket.undecided)
        bracket.undecided = {value, value};
    else
        bracket.undecided =
            std::minmax({bracket.undecided->first, bracket.undecided->second, value});
    trim(bracket);
}

/// The middle; none where rounding leaves nothing in between.
std::optional<double> inside(double low, double high) {
    const double middle = std::midpoint(low, high);
    return middle > low && middle < high ? std::optional(middle) : std::nullopt;
}

std::optional<double> next(const LimitBracket& bracket, double tolerance) {
    const double low = bracket.last_shakedown, high = bracket.first_ratcheting;
    if (high - low <= tolerance) return {};
    if (!bracket.undecided) return inside(low, high);
    const auto [first, last] = *bracket.undecided;
    if (first - low > tolerance) return inside(low, first);
    if (high - last > tolerance) return inside(last, high);
    return {};
}

}  // namespace

LimitBracket find_limit(const std::function<State(double)>& verdict, double low, double high,
                        double tolerance) {
    LimitBracket bracket{low, high};
    while (const auto value = next(bracket, tolerance)) note(bracket, *value, verdict(*value));
    return bracket;
}

}  // namespace tricontact::comparisons
