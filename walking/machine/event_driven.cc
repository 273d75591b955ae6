#include "walking/machine/event_driven.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "walking/machine/linear_stability.h"

namespace tricontact::walking {

namespace {

// No step is longer than this share of the shortest period: within one, a guard has at most one
// minimum.
constexpr double share_of_period = 0.1;

// After an event the guards that have just passed stand at zero. A short step lets them rise above
// rounding; it grows fivefold from one to the next.
constexpr double share_after_event = 1e-4;

double longest_step(const Machine& machine) {
    const double frequency = std::max(highest_frequency(machine), machine.excitation.frequency);
    return share_of_period * 2 * std::numbers::pi / frequency;
}

// Upper end of the bracket of the root: the guard has passed.
template <class Function>
double upper_root(const Function& f, double a, double b, double fa, double fb) {
    if (fa == 0) return a;
    if (fb == 0) return b;
    std::uintmax_t n_evaluations = 100;
    const boost::math::tools::eps_tolerance<double> full;
    return boost::math::tools::toms748_solve(f, a, b, fa, fb, full, n_evaluations).second;
}

constexpr double patience = 1000;

bool flies(const EventDriven& run) {
    return std::ranges::none_of(run.modes(), &ContactMode::touches);
}

// Advances to the next event but one sample at most, so that the extremes of z are met: between
// samples z is less than z'' interval^2/8 lower.
constexpr double interval = 1e-3;

void follow_to_flight(EventDriven& run, ReferenceCycle& cycle) {
    const double start = run.motion().time, end = start + patience;
    bool flew = flies(run);
    for (double time = start; time < end;) {
        std::vector<bool> sticks;
        for (const ContactMode& mode : run.modes())
            sticks.push_back(mode.state == SpotState::stick);
        run.advance_to_event(time + interval);
        const Motion motion = run.motion();
        for (std::size_t i = 0; i < sticks.size(); ++i)
            if (sticks[i]) cycle.stick_times[i] += motion.time - time;
        time = motion.time;
        cycle.period = time - start;
        cycle.z_min = std::min(cycle.z_min, motion.z);
        if (flies(run) && !flew) return;
        flew = flies(run);
    }
    throw contact::NotConverged(
        "event-driven integration: the body did not fly in 1000 units of time");
}

}  // namespace

namespace odeint = boost::numeric::odeint;
using State = ContactFlow::State;
using Stepper = odeint::runge_kutta_fehlberg78<State>;

EventDriven::EventDriven(const Machine& machine, const Motion& start, double tolerance)
    : flow_(machine, tolerance * static_displacement(machine)),
      tolerance_(tolerance * static_displacement(machine)),
      start_time_(start.time),
      start_base_(start.base),
      longest_step_(longest_step(machine)),
      next_step_(share_after_event * longest_step_),
      time_(start.time) {
    if (!(tolerance >= 1e-14 && tolerance <= 1e-4))
        throw std::invalid_argument("tolerance of the reference integrator outside 1e-14 to 1e-4");
    if (start.spots.size() != flow_.spots().size())
        throw std::invalid_argument("the start has another number of spots than the machine");
    state_ = ContactFlow::state_of(start);
    modes_ = flow_.modes_of(state_);
    start_energy_ = stored_energy(flow_.machine(), flow_.spots(), motion());
}

Motion EventDriven::motion() const {
    const double base = start_base_ + flow_.machine().kappas.kappa6 * (time_ - start_time_);
    return flow_.motion_of(state_, modes_, time_, base);
}

EnergyBalance EventDriven::energy_balance() const {
    const double kappa4 = flow_.machine().kappas.kappa4;
    const double* works = state_.data() + state_.size() - ContactFlow::n_works;
    return {.base = kappa4 * works[0],
            .excitation = kappa4 * works[1],
            .geometric = kappa4 * works[2],
            .dissipation = kappa4 * works[3],
            .stored = stored_energy(flow_.machine(), flow_.spots(), motion()) - start_energy_};
}

void EventDriven::advance_to(double time) {
    while (time_ < time) advance_to_event(time);
}

bool EventDriven::advance_to_event(double time) {
    while (time_ < time) {
        State next;
        const double step = take_step(time, next);
        const Crossing crossing = first_crossing(next, step);
        if (crossing.guard < 2 * modes_.size()) {
            pass(crossing);
            return true;
        }
        state_ = std::move(next);
        time_ = step == time - time_ ? time : time_ + step;
        n_stalled_ = 0;
    }
    return false;
}

auto EventDriven::equations() const {
    return [this](const State& state, State& rate, double time) {
        flow_.derivative(state, modes_, time, rate);
    };
}

double EventDriven::take_step(double end, State& next) {
    // No error is smaller than the rounding of what it belongs to.
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    auto stepper = odeint::make_controlled(tolerance_, rounding, Stepper());
    // Time has to go on.
    const double shortest =
        std::numeric_limits<double>::epsilon() * std::max(longest_step_, 2 * std::abs(time_));
    double wanted = std::min(next_step_, longest_step_);
    for (;;) {
        const double taken = std::min(wanted, end - time_);
        double time = time_, step = taken;
        next = state_;
        const bool converged = stepper.try_step(equations(), next, time, step) == odeint::success &&
                               std::ranges::all_of(next, [](double x) { return std::isfinite(x); });
        // A step cut short by the end says nothing about the next one.
        if (converged) next_step_ = taken < wanted ? std::max(step, wanted) : step;
        if (converged) return taken;
        wanted = std::min(step, taken / 2);
        if (wanted < shortest)
            throw contact::NotConverged(
                fmt::format("event-driven integration: at t = {}, phi = {:.3g}, an error above the "
                            "tolerance of {:.3g} b remains with steps of {:.3g}",
                            time_, state_[2], tolerance_, wanted));
    }
}

State EventDriven::after(double step) const {
    State there = state_;
    Stepper().do_step(equations(), there, time_, step);
    return there;
}

double EventDriven::crossing_of(std::size_t guard, const Guard& start, const Guard& end,
                                double step) const {
    const auto at = [&](double elapsed) {
        return flow_.guards(after(elapsed), modes_, time_ + elapsed)[guard];
    };
    const auto value = [&](double elapsed) { return at(elapsed).value; };
    if (end.value < 0)
        return start.value > 0 ? upper_root(value, 0, step, start.value, end.value) : 0;
    if (!(start.value > 0 && start.rate < 0 && end.rate > 0)) return contact::infinity;
    // Positive at both ends, it may have dipped below zero between them.
    const double lowest =
        upper_root([&](double elapsed) { return at(elapsed).rate; }, 0, step, start.rate, end.rate);
    const double least = value(lowest);
    return least < 0 ? upper_root(value, 0, lowest, start.value, least) : contact::infinity;
}

EventDriven::Crossing EventDriven::first_crossing(const State& end, double step) const {
    const std::vector<Guard> before = flow_.guards(state_, modes_, time_);
    const std::vector<Guard> then = flow_.guards(end, modes_, time_ + step);
    Crossing first{before.size(), step};
    for (std::size_t guard = 0; guard < before.size(); ++guard) {
        const double elapsed = crossing_of(guard, before[guard], then[guard], step);
        if (elapsed < first.after || (elapsed == step && first.guard == before.size()))
            first = {guard, elapsed};
    }
    return first;
}

void EventDriven::pass(const Crossing& crossing) {
    state_ = after(crossing.after);
    time_ += crossing.after;
    flow_.pass(crossing.guard, state_, modes_);
    next_step_ = share_after_event * longest_step_;
    n_stalled_ = crossing.after > 0 ? 0 : n_stalled_ + 1;
    if (n_stalled_ > 4 * modes_.size())
        throw contact::NotConverged(fmt::format(
            "event-driven integration: at t = {} the spots change between stick, slip and "
            "release without end: {} events at one time",
            time_, n_stalled_));
}

ReferenceCycle reference_cycle(EventDriven& run) {
    const std::size_t n_spots = run.modes().size();
    ReferenceCycle before;
    before.stick_times.resize(n_spots);
    follow_to_flight(run, before);
    const EnergyBalance earlier = run.energy_balance();
    ReferenceCycle cycle{.start = run.motion(),
                         .stick_times = std::vector<double>(n_spots),
                         .z_min = run.motion().z};
    follow_to_flight(run, cycle);
    for (double& time : cycle.stick_times) time /= cycle.period;
    cycle.balance = run.energy_balance();
    for (const auto member :
         {&EnergyBalance::base, &EnergyBalance::excitation, &EnergyBalance::geometric,
          &EnergyBalance::dissipation, &EnergyBalance::stored})
        cycle.balance.*member -= earlier.*member;
    // The work of the base is its way times the mean force.
    cycle.spring_force = cycle.balance.base / (run.motion().base - cycle.start.base);
    return cycle;
}

}  // namespace tricontact::walking
