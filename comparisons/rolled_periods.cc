#include "comparisons/rolled_periods.h"

#include <algorithm>
#include <cmath>

namespace tricontact::comparisons {

using contact::State;

namespace {

constexpr std::size_t fewest_looked_at = 4;
constexpr double still_decaying = 0.99;  // of an increment over that a quarter of the run before

}  // namespace

State fate(std::span<const RolledPeriod> periods, double negligible) {
    if (periods.empty()) return State::undecided;
    const RolledPeriod& last = periods.back();
    if (last.something_sticks)
        return std::abs(last.increment) <= negligible ? State::shakedown : State::undecided;
    const std::size_t stride = std::max(fewest_looked_at, periods.size() / 4);
    if (periods.size() <= stride || !(last.increment > negligible)) return State::undecided;
    const auto recent = periods.last(stride + 1);
    const bool freed = std::none_of(recent.begin(), recent.end(),
                                    [](const RolledPeriod& p) { return p.something_sticks; });
    const bool decays = last.increment < still_decaying * recent.front().increment;
    return freed && !decays ? State::ratcheting : State::undecided;
}

}  // namespace tricontact::comparisons
