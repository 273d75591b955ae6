#include "contact/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "contact/base/number_text.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

constexpr double settled_shift = 1e-7;  // per period, over U_max
constexpr double settled_work = 1e-6;   // per period, over mu F_N U_max
constexpr double stick_threshold = 10;  // accuracies of a step, see SurfaceModel::update_slip
constexpr std::size_t fewest_repeated = 4;
constexpr double constant_work = 0.01;     // relative change over the periods looked at
constexpr double longest_way_to_rest = 2;  // over U_max, at which all of a contact slides
constexpr double known_increment = 0.01;   // relative
// Longest relaxation, and the slower retardation that belongs to it, decay to 5 %.
constexpr double time_constants = 3;
constexpr double least_error = 0.1;  // of what is continued, relative

/// Periods in which the slowest branch is forgotten.
double memory_of(const Case& c, double amplitude) {
    if (!c.relaxation || !c.rolling || !(c.rolling->speed > 0) || !(amplitude > 0)) return 0;
    double slowest = 0;
    for (const Relaxation::Branch& branch : c.relaxation->branches)
        slowest = std::max(slowest, branch.time);
    const double retardation = slowest * c.relaxation->instantaneous_ratio();
    return time_constants * retardation * c.rolling->speed / (4 * amplitude);
}

/// How the last values of a series continue, see still_to_come.
struct Continued {
    Bounded rest;
    double time_constant;  ///< in periods, at the last value
};

std::optional<Continued> continued(std::span<const double> series) {
    const std::size_t n = series.size(), stride = std::max<std::size_t>(1, n / 6);
    if (n < fewest_repeated) return {};
    const auto s = static_cast<double>(stride);
    const auto decay = [&](std::size_t at) {  // per period, before that value
        return std::log(series[at - stride] / series[at]) / s;
    };
    const double now = decay(n - 1), before = decay(n - 1 - stride);
    if (!(now > 0) || !(before > 0) || std::isinf(now + before)) return {};
    const double growth = std::clamp((1 / now - 1 / before) / s, 0., 0.99);
    const double constant = 1 / now + growth * s / 2;
    const double geometric = series[n - 1] / std::expm1(1 / constant);
    const double value = geometric / (1 - growth);
    const double slower = geometric / (1 - std::min(2 * growth, (1 + growth) / 2));
    return Continued{{value, std::max(std::abs(slower - value), std::abs(value - geometric))},
                     constant};
}

std::vector<double> increments(const std::vector<RolledPeriod>& periods) {
    std::vector<double> result;
    for (const RolledPeriod& period : periods) result.push_back(period.increment);
    return result;
}

std::vector<double> differences(const std::vector<double>& values) {
    std::vector<double> result(values.size());
    std::adjacent_difference(values.begin(), values.end(), result.begin());
    if (!result.empty()) result.erase(result.begin());
    return result;
}

}  // namespace

const char* name_of(State state) {
    constexpr std::array names{"shakedown", "cyclic-slip", "ratcheting", "undecided"};
    return names[static_cast<std::size_t>(state)];
}

bool has_constant_loads(const Case& c) {
    return c.load.normal_amplitude_ratio == 0 && c.load.tangential_amplitude_ratio == 0;
}

Judged judged(const Case& c, double accuracy, bool coupled, double amplitude,
              double tangential_ratio) {
    Judged result;
    result.negligible_shift = std::max(settled_shift, accuracy);
    result.negligible_work = std::max(settled_work, stick_threshold * accuracy);
    result.has_load = c.load.is_tangential();
    result.memory = memory_of(c, amplitude);
    result.limit_accuracy = stick_threshold * accuracy;
    if (!coupled && !c.relaxation && c.load.tangential_amplitude_ratio == 0)
        result.tangential_ratio = std::abs(tangential_ratio);
    return result;
}

bool Judge::repeats_its_work() const {
    const std::size_t n = std::max(fewest_repeated, periods_.size() / 4);
    if (periods_.size() <= n) return false;  // the first period is none of them
    const auto recent = std::span(periods_).last(n);
    if (!std::ranges::all_of(recent, [&](const RolledPeriod& p) { return stands(p); }))
        return false;
    const auto [least, most] = std::ranges::minmax(recent, {}, &RolledPeriod::work);
    return least.work > judged_.negligible_work && most.work <= (1 + constant_work) * least.work;
}

bool Judge::ratchets() const {
    const std::size_t n = std::max(fewest_repeated, periods_.size() / 4) + 1;
    if (periods_.size() < n) return false;
    const auto recent = std::span(periods_).last(n);
    const double sign = std::copysign(1, recent.back().increment);
    const auto goes_on = [&](const RolledPeriod& p) {
        return !p.something_sticks && sign * p.increment > judged_.negligible_shift;
    };
    if (!std::ranges::all_of(recent, goes_on)) return false;
    const auto size = [](const RolledPeriod& p) { return std::abs(p.increment); };
    const double most = size(std::ranges::max(recent.first(n / 2), {}, size));
    const double least = size(std::ranges::min(recent.last(n - n / 2), {}, size));
    const double decline = (most - least) / (static_cast<double>(n) / 2);  // per period
    // An increment d that declines by a share r of itself in each period adds d/r.
    return least * least > longest_way_to_rest * decline;
}

State Judge::decide() const {
    if (!has_forgotten()) return State::undecided;
    if (stands(periods_.back()) && std::abs(periods_.back().work) <= judged_.negligible_work)
        return State::shakedown;
    if (repeats_its_work()) return State::cyclic_slip;
    return ratchets() ? State::ratcheting : State::undecided;
}

Verdict Judge::verdict() const {
    Verdict result{.state = state_, .by_limit = by_limit_, .missing = missing()};
    if (periods_.empty()) return result;
    const std::vector<double> all = increments(periods_);
    if (state_ == State::ratcheting) {
        const Bounded change = still_to_come(differences(all), judged_.negligible_shift);
        result.remaining_error = std::abs(change.value) + change.error;
        return result;
    }
    const Bounded rest = still_to_come(all, judged_.negligible_shift);
    result.remaining = rest.value;
    // Where nothing holds the indenter, small increments may go on for ever.
    if (state_ != State::undecided || has_hold(periods_.back()))
        result.remaining_error = rest.error;
    return result;
}

bool Judge::is_known() const {
    if (state_ == State::undecided || periods_.empty()) return false;
    const double error = verdict().remaining_error;
    return state_ == State::ratcheting
               ? error <= known_increment * std::abs(periods_.back().increment)
               : error <= known_shift;
}

std::string Judge::missing() const {
    constexpr const char* more = "; raise rolling.periods";
    if (state_ != State::undecided || periods_.empty()) return {};
    const RolledPeriod& last = periods_.back();
    const double step = std::abs(last.increment);
    if (!has_forgotten())
        return fmt::format(
            "the substrate still creeps: {:.0f} periods last as long as its memory{}",
            std::ceil(judged_.memory), more);
    if (has_hold(last)) {
        if (step <= judged_.negligible_shift)
            return fmt::format(
                "the shift stands, but the friction's work per period, {:.2g} of U_max times what "
                "friction carries, has neither vanished nor stayed the same for {} periods{}",
                last.work, std::max(fewest_repeated, periods_.size() / 4), more);
        // What holds the indenter while it moves by U_max would have slipped.
        double moved = 0;
        for (const RolledPeriod& p : std::span(periods_).last(periods_.size() / 2))
            moved += p.something_sticks ? std::abs(p.increment) : -infinity;
        if (moved > longest_way_to_rest)
            return "the shift grows although points seem to stick throughout: they slip by less "
                   "than ten times the solver's tolerance in a step; lower it";
        return fmt::format(
            "the shift still grows by {} U_max per period, held back by points "
            "that stick throughout{}",
            significant(step, 2), more);
    }
    if (step <= judged_.negligible_shift)
        return "no point sticks throughout a period, so that increments below the solver's "
               "tolerance may never end; lower it";
    return fmt::format(
        "the increments, {:.2g} U_max in the last period, may still sink to zero or "
        "stay{}",
        step, more);
}

bool Judge::has_settled() const {
    return has_forgotten() && std::abs(periods_.back().increment) <= settled_shift &&
           std::abs(periods_.back().work) <= settled_work;
}

Bounded still_to_come(std::span<const double> series, double noise) {
    std::size_t n = series.size();  // of those above the noise
    while (n > 0 && std::abs(series[n - 1]) <= noise) --n;
    const auto quiet = static_cast<double>(series.size() - n);
    const Bounded unknown{0, quiet > 0 ? noise : infinity};
    const auto now = continued(series.first(n)), before = continued(series.first(n - (n > 0)));
    if (!now || !before) return unknown;
    // Largest disagreement with extrapolations from earlier periods, scaled to the present
    // increment.
    double spread = 0, since = 0;
    for (std::size_t k = 1; k <= std::max<std::size_t>(2, n / 4); ++k) {
        since += series[n - k];
        if (const auto said = continued(series.first(n - k)))
            spread = std::max(spread, std::abs((said->rest.value - since - now->rest.value) *
                                               series[n - 1] / series[n - 1 - k]));
    }
    const double since_then = std::exp(-quiet / now->time_constant);
    const double value = now->rest.value * since_then;
    return {value, (now->rest.error + spread) * since_then + least_error * std::abs(value) + noise};
}

State state_of(double low, double high, double negligible) {
    if (high < negligible) return State::shakedown;
    return low > 0 ? State::ratcheting : State::undecided;
}

}  // namespace tricontact::contact
