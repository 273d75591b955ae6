#include "rolling/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::rolling {

namespace {

// Of the friction limit, the creepage of full sliding and the contact's size: far below what the
// grid costs in accuracy.
constexpr double steady_change = 1e-5;
constexpr double farthest_rolled = 1000;  // half lengths of the contact

/// Largest change between two states [-].
double change(const RollingState& from, const RollingState& to,
              const contact::FrictionLaw& friction) {
    const contact::FrictionLaw::Total total{to.normal_force, to.friction_bound};
    const double force = friction.limit(total);
    const double creepage = friction.ratio(total) * to.indentation / to.half_length;
    double worst = 0;
    for (const auto& [a, b, unit] : {
             std::array{from.force[0], to.force[0], force},
             std::array{from.force[1], to.force[1], force},
             std::array{from.normal_force, to.normal_force, to.normal_force},
             std::array{from.creepage.longitudinal, to.creepage.longitudinal, creepage},
             std::array{from.creepage.lateral, to.creepage.lateral, creepage},
             std::array{from.indentation, to.indentation, to.indentation},
             std::array{from.pressure_lead, to.pressure_lead, to.half_length},
         })
        worst = contact::larger(worst, std::abs(b - a) / unit);
    return worst;
}

/// What rolling on for ever would still change, if each contact length changes the same fraction of
/// what the one before did.
bool is_steady(const std::vector<RollingState>& states, double cell,
               const contact::FrictionLaw& friction) {
    const int window = std::max(1, static_cast<int>(2 * states.back().half_length / cell));
    const int last = static_cast<int>(states.size()) - 1;
    if (last < 2 * window + 1) return false;  // at rest nothing slid yet
    const double before = change(states[last - 2 * window], states[last - window], friction);
    const double now = change(states[last - window], states[last], friction);
    return now <= steady_change / 100 ||
           (now < before && now * now <= steady_change * (before - now));
}

}  // namespace

using contact::TangentialControl;

TransientRolling::TransientRolling(const contact::Substrate& substrate,
                                   const RollingProblem& problem)
    : problem_(problem),
      cell_(substrate.relaxed().points().spacing[0]),
      model_("rolling", substrate, problem.indenter, problem.friction, problem.tolerance,
             {.coupling = problem.coupling}) {}

/// What is prescribed of a step, but for the way that it slides by.
contact::LoadStep TransientRolling::step() const {
    contact::LoadStep step;
    step.normal = problem_.normal;
    for (int d = 0; d < 2; ++d)
        step.tangential[d] =
            problem_.drive.creepage[d]
                ? TangentialControl{TangentialControl::Kind::shift, shift_[d]}
                : TangentialControl{TangentialControl::Kind::force, problem_.drive.force[d]};
    if (problem_.drive.force_ratio && !problem_.drive.creepage[0])
        step.tangential[0] = {TangentialControl::Kind::ratio, *problem_.drive.force_ratio};
    return step;
}

RollingState TransientRolling::press() {
    contact::LoadStep press = step();
    press.duration = contact::infinity;
    const contact::StepRecord pressed = model_.advance(press);
    shift_ = pressed.shift;  // of the forces at rest: no creepage
    return record(pressed);
}

RollingState TransientRolling::roll() {
    if (problem_.rate || problem_.friction_temperature)
        throw contact::InputError(
            "rolling from rest: friction that changes with the speed of slip or the temperature is "
            "known in the steady state alone; leave it out");
    contact::LoadStep next = step();
    next.duration = problem_.speed > 0 ? cell_ / problem_.speed : contact::infinity;
    for (int d = 0; d < 2; ++d)
        if (problem_.drive.creepage[d])
            next.tangential[d].value += *problem_.drive.creepage[d] * cell_;
    ++n_rolled_;
    const contact::Vector2 before = shift_;
    const contact::StepRecord step = model_.roll(next, problem_.drive.spin * cell_);
    shift_ = step.shift;
    RollingState state = record(step);
    state.creepage = {(shift_[0] - before[0]) / cell_, (shift_[1] - before[1]) / cell_,
                      problem_.drive.spin};
    return state;
}

RollingState TransientRolling::record(const contact::StepRecord& step) const {
    RollingState state = state_of(surface(), *problem_.indenter);
    state.distance = n_rolled_ * cell_;
    state.indentation = step.indentation;
    if (n_rolled_ > 0) state.material_dissipation = step.material_dissipation / cell_;
    state.iterations = step.normal_iterations + step.tangential_iterations;
    state.residual =
        std::max({step.normal_residual, step.tangential_residual, step.force_residual});
    return state;
}

contact::Surface TransientRolling::surface() const {
    contact::Surface surface = model_.surface();
    for (auto* per_way : {&surface.slip_x, &surface.slip_y, &surface.dissipation})
        for (double& value : *per_way) value = n_rolled_ > 0 ? value / cell_ : 0;
    return surface;
}

SteadyRolling roll_until_steady(TransientRolling& rolling, std::vector<RollingState> states) {
    if (rolling.problem().heat)
        throw contact::InputError(
            "rolling until steady: temperatures are known where the steady state is solved "
            "directly; leave out heat");
    const contact::FrictionLaw& friction = *rolling.problem().friction;
    while (!is_steady(states, rolling.cell(), friction)) {
        if (states.back().distance > farthest_rolled * states.back().half_length)
            throw contact::NotConverged(fmt::format(
                "rolling: not steady after {:.4g} m, {:.0f} half lengths of the contact",
                states.back().distance, farthest_rolled));
        states.push_back(rolling.roll());
    }
    SteadyRolling steady{states.back(), rolling.surface(), rolling.audit()};
    steady.state.distance = contact::infinity;
    return steady;
}

SteadyRolling steady_rolling(const contact::Substrate& substrate, const RollingProblem& problem) {
    if (!substrate.relaxes()) return steady_rolling(substrate.compliance(), problem);
    TransientRolling rolling(substrate, problem);
    return roll_until_steady(rolling, {rolling.press()});
}

}  // namespace tricontact::rolling
