#include "rolling/transient_rolling.h"

#include <algorithm>
#include <limits>

#include "rolling/rolling_state.h"

namespace tricontact::rolling {

using contact::TangentialControl;

TransientRolling::TransientRolling(const contact::Substrate& substrate,
                                   const RollingProblem& problem)
    : problem_(problem),
      cell_(substrate.relaxed().points().spacing[0]),
      model_("rolling", substrate, problem.indenter, problem.friction_coefficient,
             problem.tolerance, {.coupling = problem.coupling}) {}

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
    press.duration = std::numeric_limits<double>::infinity();
    const contact::StepRecord pressed = model_.advance(press);
    shift_ = pressed.shift;  // of the forces at rest: no creepage
    return record(pressed);
}

RollingState TransientRolling::roll() {
    contact::LoadStep next = step();
    next.duration =
        problem_.speed > 0 ? cell_ / problem_.speed : std::numeric_limits<double>::infinity();
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

}  // namespace tricontact::rolling
