#include "rolling/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "contact/largest.h"
#include "rolling/steady_rolling.h"
#include "rolling/transient_rolling.h"

namespace tricontact::rolling {

namespace {

// Of the friction limit, the creepage of full sliding and the contact's size: far below what the
// grid costs in accuracy.
constexpr double steady_change = 1e-5;
constexpr double farthest = 1000;  // half lengths of the contact

/// Largest change between two states [-].
double change(const RollingState& from, const RollingState& to, double friction_coefficient) {
    const double force = friction_coefficient * to.normal_force;
    const double creepage = friction_coefficient * to.indentation / to.half_length;
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
bool is_steady(const std::vector<RollingState>& states, double cell, double friction_coefficient) {
    const int window = std::max(1, static_cast<int>(2 * states.back().half_length / cell));
    const int last = static_cast<int>(states.size()) - 1;
    if (last < 2 * window + 1) return false;  // at rest nothing slid yet
    const double before =
        change(states[last - 2 * window], states[last - window], friction_coefficient);
    const double now = change(states[last - window], states[last], friction_coefficient);
    return now <= steady_change / 100 ||
           (now < before && now * now <= steady_change * (before - now));
}

/// Over a relaxing substrate, until it is steady.
void roll_until_steady(TransientRolling& rolling, double friction_coefficient, double cell,
                       std::vector<RollingState>& states) {
    while (!is_steady(states, cell, friction_coefficient)) {
        if (states.back().distance > farthest * states.back().half_length)
            throw contact::NotConverged(fmt::format(
                "rolling: not steady after {:.4g} m, {:.0f} half lengths of the contact",
                states.back().distance, farthest));
        states.push_back(rolling.roll());
    }
}

}  // namespace

RollingHistory run(const contact::Substrate& substrate, const RollingProblem& problem) {
    RollingHistory history;
    if (!substrate.relaxes()) {
        SteadyRolling steady = steady_rolling(substrate.compliance(), problem);
        history.steady = steady.state;
        history.surface = std::move(steady.surface);
        history.audit = std::move(steady.audit);
        if (!(problem.distance > 0)) return history;
    }
    TransientRolling rolling(substrate, problem);
    std::vector<RollingState> states = {rolling.press()};
    const double cell = substrate.relaxed().points().spacing[0];
    const int n = static_cast<int>(std::lround(problem.distance / cell));
    for (int i = 0; i < n; ++i) states.push_back(rolling.roll());
    history.transient = states;
    if (substrate.relaxes()) {
        roll_until_steady(rolling, problem.friction_coefficient, cell, states);
        history.steady = states.back();
        history.surface = rolling.surface();
    }
    for (const contact::Audit::Check& check : rolling.audit().checks())
        history.audit.record(check.name, check.worst, check.allowed);
    return history;
}

}  // namespace tricontact::rolling
