#include "comparisons/quantities/relaxation_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

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

std::optional<double> relative_error(std::optional<double> elastic,
                                     std::optional<double> relaxing) {
    if (!elastic || !relaxing || *relaxing == 0) return {};
    return *elastic / *relaxing - 1;
}

/// Speed at which De = 2 pi f tau has this value, f = v/(4 W).
double speed_of(double deborah, double time, double amplitude) {
    return deborah * 2 * amplitude / (std::numbers::pi * time);
}

double slowest_time(const Relaxation& relaxation) {
    double time = 0;
    for (const auto& branch : relaxation.branches) time = std::max(time, branch.time);
    return time;
}
double fastest_time(const Relaxation& relaxation) {
    double time = slowest_time(relaxation);
    for (const auto& branch : relaxation.branches) time = std::min(time, branch.time);
    return time;
}

/// The search, over x = ln v.
class Search {
  public:
    Search(const ErrorAtSpeed& error, SpeedLimit& result) : error_(error), result_(result) {}

    /// From `speed` until the error passes the limit, within `slowest` and `fastest`.
    void go(double speed, double slowest, double fastest) {
        result_.slowest = result_.fastest = speed;
        double at = excess(speed);
        const double factor = at > 0 ? 1 / step : step;
        while (true) {
            const double next = speed * factor;
            if (next < slowest || next > fastest) return give_up(at);
            const double there = excess(next);
            if ((at > 0) != (there > 0)) return refine(speed, at, next, there);
            speed = next;
            at = there;
        }
    }

  private:
    /// ln(error/limit): nearly a straight line over ln v.
    double excess(double speed) {
        ++result_.runs;
        result_.slowest = std::min(result_.slowest, speed);
        result_.fastest = std::max(result_.fastest, speed);
        const auto error = error_(speed);
        if (!error)
            throw std::runtime_error(fmt::format("the error is undefined at {:.3g} m/s", speed));
        return std::log(std::max(*error, least_error) / SpeedLimit::limit);
    }

    void give_up(double at) {
        result_.why_none =
            at > 0
                ? fmt::format("it is still more at {:.3g} m/s, the slowest tried", result_.slowest)
                : fmt::format("it stays less up to {:.3g} m/s, the fastest tried", result_.fastest);
    }

    void refine(double one, double at_one, double other, double at_other) {
        if (one > other) {
            std::swap(one, other);
            std::swap(at_one, at_other);
        }
        std::uintmax_t evaluations = 20;  // about 5 are needed
        const auto [low, high] = boost::math::tools::toms748_solve(
            [&](double x) { return excess(std::exp(x)); }, std::log(one), std::log(other), at_one,
            at_other,
            [](double a, double b) { return std::abs(b - a) < std::log1p(SpeedLimit::resolution); },
            evaluations);
        result_.speed = std::exp((low + high) / 2);
    }

    const ErrorAtSpeed& error_;
    SpeedLimit& result_;
};

}  // namespace

std::optional<DriveValues> drive_values(const Case& c, double amplitude) {
    if (!c.relaxation || !c.rolling || !(c.rolling->speed > 0) || !(amplitude > 0)) return {};
    DriveValues drive;
    drive.amplitude = amplitude;
    drive.frequency = c.rolling->speed / (4 * amplitude);
    const double omega = 2 * std::numbers::pi * drive.frequency;
    const auto modulus = c.substrate.shear_modulus() * c.relaxation->dynamic_ratio(omega);
    drive.storage = modulus.real();
    drive.loss = modulus.imag();
    for (const auto& branch : c.relaxation->branches) drive.deborah.push_back(omega * branch.time);
    return drive;
}

Case elastic_twin(const Case& c) {
    Case twin = c;
    twin.relaxation.reset();
    twin.relaxation_input = {};
    twin.dma_fit.reset();
    twin.load.press_time.reset();
    twin.load.hold = 0;
    if (twin.rolling) twin.rolling->speed = 0;
    return twin;
}

RunValues run_values(const contact::History& history) {
    RunValues values;
    values.static_shift = history.static_shift;
    const auto& shift = history.shift_per_period;
    if (shift.empty()) return values;
    const double before = shift.size() > 1 ? shift[shift.size() - 2] : history.static_shift;
    values.final_shift = shift.back();
    values.increment = shift.back() - before;
    values.limit = history.limit_tangential_ratio;
    values.state = history.verdict.state;
    return values;
}

bool judged_by_increment(const RunValues& elastic) {
    return elastic.state == State::ratcheting;
}

std::optional<double> twin_error(const RunValues& elastic, const RunValues& relaxing) {
    return judged_by_increment(elastic) ? relative_error(elastic.increment, relaxing.increment)
                                        : relative_error(elastic.final_shift, relaxing.final_shift);
}

std::optional<double> TwinComparison::static_error() const {
    if (!elastic) return {};
    return relative_error(elastic->static_shift, relaxing.static_shift);
}

std::optional<double> TwinComparison::final_error() const {
    if (!elastic) return {};
    return relative_error(elastic->final_shift, relaxing.final_shift);
}

std::optional<double> TwinComparison::settled_error() const {
    const bool both = elastic && elastic->state && relaxing.state &&
                      contact::settles(*elastic->state) && contact::settles(*relaxing.state);
    return both ? final_error() : std::nullopt;
}

std::optional<double> TwinComparison::increment_error() const {
    const bool both =
        elastic && elastic->state == State::ratcheting && relaxing.state == State::ratcheting;
    return both ? relative_error(elastic->increment, relaxing.increment) : std::nullopt;
}

std::optional<double> TwinComparison::limit_error() const {
    if (!elastic) return {};
    return relative_error(elastic->limit, relaxing.limit);
}

SpeedLimit find_speed_limit(const Relaxation& relaxation, double amplitude,
                            const ErrorAtSpeed& error) {
    SpeedLimit result;
    const double slow = slowest_time(relaxation), fast = fastest_time(relaxation);
    // Half a step of slack: rounding does not decide whether a step is taken.
    const double slack = std::sqrt(step);
    try {
        Search(error, result)
            .go(speed_of(first_deborah, slow, amplitude),
                speed_of(least_deborah, slow, amplitude) / slack,
                speed_of(largest_deborah, fast, amplitude) * slack);
    } catch (const std::runtime_error& failure) {
        result.why_none = failure.what();
    }
    if (result.speed) result.frequency = *result.speed / (4 * amplitude);
    return result;
}

}  // namespace tricontact::comparisons
