#include "comparisons/quantities/relaxation_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

#include "contact/base/stopped.h"
#include "contact/relaxing_case.h"
#include "contact/verdict.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::Relaxation;
using contact::State;

// Deborah numbers: where the search begins, and between which it stays. Far below 1 the error is in
// proportion to De, so beginning at 0.01 finds the slowest speed; at 1e-4 it is next to nothing,
// and beyond 100 the fastest branch has no time to relax.
constexpr double first_deborah = 0.01, least_deborah = 1e-4, largest_deborah = 100;
constexpr double step = 10;
constexpr double least_error = 1e-12;  // the logarithm of rounding errors has no meaning

/// Speed at which De = 2 pi f tau has this value, f = v/(4 W).
double speed_of(double deborah, double time, double amplitude) {
    return deborah * 2 * amplitude / (std::numbers::pi * time);
}

/// From `speed` until the error passes the limit, within `slowest` and `fastest`.
void search(const ErrorAtSpeed& error, double speed, double slowest, double fastest,
            SpeedLimit& result) {
    // ln(error/limit): nearly a straight line over ln v.
    const auto excess = [&](double v) {
        ++result.runs;
        result.slowest = std::min(result.slowest, v);
        result.fastest = std::max(result.fastest, v);
        const auto found = error(v);
        if (!found)
            throw contact::NotConverged(fmt::format("the error is undefined at {:.3g} m/s", v));
        return std::log(std::max(*found, least_error) / SpeedLimit::limit);
    };
    result.slowest = result.fastest = speed;
    double at = excess(speed), next = speed, there = at;
    const double factor = at > 0 ? 1 / step : step;
    while ((at > 0) == (there > 0)) {
        speed = next;
        at = there;
        next = speed * factor;
        if (next < slowest || next > fastest) {
            result.why_none = at > 0
                                  ? fmt::format("it is still more at {:.3g} m/s, the slowest tried",
                                                result.slowest)
                                  : fmt::format("it stays less up to {:.3g} m/s, the fastest tried",
                                                result.fastest);
            return;
        }
        there = excess(next);
    }
    if (speed > next) {
        std::swap(speed, next);
        std::swap(at, there);
    }
    std::uintmax_t evaluations = 20;  // about 5 are needed
    const auto [low, high] = boost::math::tools::toms748_solve(
        [&](double x) { return excess(std::exp(x)); }, std::log(speed), std::log(next), at, there,
        [](double a, double b) { return std::abs(b - a) < std::log1p(SpeedLimit::resolution); },
        evaluations);
    result.speed = std::exp((low + high) / 2);
}

}  // namespace

std::optional<DriveValues> drive_values(const Case& c, double amplitude) {
    if (!c.relaxation || !c.rolling || !(c.rolling->speed > 0) || !(amplitude > 0)) return {};
    const double frequency = c.rolling->speed / (4 * amplitude);
    const double omega = 2 * std::numbers::pi * frequency;
    const auto modulus =
        contact::relaxing_material(c).shear_modulus() * c.relaxation->dynamic_ratio(omega);
    DriveValues drive{amplitude, frequency, modulus.real(), modulus.imag(), {}};
    for (const auto& branch : c.relaxation->branches) drive.deborah.push_back(omega * branch.time);
    return drive;
}

Case elastic_twin(const Case& c) {
    Case twin = c;
    twin.relaxation.reset();
    twin.load.press_time.reset();
    twin.load.hold = 0;
    if (twin.rolling) twin.rolling->speed = 0;
    return twin;
}

std::optional<double> relative_error(std::optional<double> other, std::optional<double> run) {
    if (!other || !run || *run == 0) return {};
    return *other / *run - 1;
}

RunValues run_values(const contact::History& history) {
    RunValues values{history.static_shift};
    if (!history.steps.empty()) {
        values.normal_force = history.steps.back().normal_force;
        values.indentation = history.steps.back().indentation;
    }
    const auto& shift = history.shift_per_period;
    if (shift.empty()) return values;
    values.state = history.verdict.state;
    values.final_shift = shift.back();
    values.increment =
        shift.back() - (shift.size() > 1 ? shift[shift.size() - 2] : history.static_shift);
    values.limit = history.limit_tangential_ratio;
    return values;
}

bool judged_by_increment(const RunValues& elastic) {
    return elastic.state == State::ratcheting;
}

std::optional<double> twin_error(const RunValues& elastic, const RunValues& relaxing) {
    return judged_by_increment(elastic) ? relative_error(elastic.increment, relaxing.increment)
                                        : relative_error(elastic.final_shift, relaxing.final_shift);
}

std::optional<double> RunComparison::error_of(std::optional<double> RunValues::*value) const {
    return other ? relative_error((*other).*value, run.*value) : std::nullopt;
}

std::optional<double> RunComparison::static_error() const {
    return other ? relative_error(other->static_shift, run.static_shift) : std::nullopt;
}

std::optional<double> RunComparison::settled_error() const {
    const bool both = other && other->state && run.state && contact::settles(*other->state) &&
                      contact::settles(*run.state);
    return both ? final_error() : std::nullopt;
}

std::optional<double> RunComparison::increment_error() const {
    const bool both = other && other->state == State::ratcheting && run.state == State::ratcheting;
    return both ? error_of(&RunValues::increment) : std::nullopt;
}

SpeedLimit find_speed_limit(const Relaxation& relaxation, double amplitude,
                            const ErrorAtSpeed& error) {
    SpeedLimit result;
    const auto [fast, slow] =
        std::ranges::minmax(relaxation.branches, {}, &Relaxation::Branch::time);
    // Half a step of slack: rounding does not decide whether a step is taken.
    const double slack = std::sqrt(step);
    const std::string why = contact::why_it_stopped([&] {
        search(error, speed_of(first_deborah, slow.time, amplitude),
               speed_of(least_deborah, slow.time, amplitude) / slack,
               speed_of(largest_deborah, fast.time, amplitude) * slack, result);
    });
    if (!why.empty()) result.why_none = why;
    if (result.speed) result.frequency = *result.speed / (4 * amplitude);
    return result;
}

}  // namespace tricontact::comparisons
