#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/event_driven.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::contact_flow_test {
namespace {

using State = ContactFlow::State;

State moved(const State& state, const State& rate, double time) {
    State there = state;
    for (std::size_t i = 0; i < state.size(); ++i) there[i] += time * rate[i];
    return there;
}

/// Rates of guards beside central differences along the flow, over `scale`: their second order is
/// below 1e-8 of what the guards change by in a unit of time.
void expect_rates(const ContactFlow& flow, const State& state,
                  const std::vector<ContactMode>& modes, double scale) {
    constexpr double h = 1e-5;
    State rate;
    flow.derivative(state, modes, 0, rate);
    const auto guards = flow.guards(state, modes, 0),
               after = flow.guards(moved(state, rate, h), modes, h),
               before = flow.guards(moved(state, rate, -h), modes, -h);
    for (std::size_t i = 0; i < guards.size(); ++i) {
        if (!std::isfinite(guards[i].value)) continue;
        const double slope = (after[i].value - before[i].value) / (2 * h);
        EXPECT_NEAR(guards[i].rate / scale, slope / scale, 1e-6) << i;
    }
}

/// In motion, every spot slipping: modes that the flow itself finds.
void expect_rates_of_slip(const Machine& machine, const Motion& motion) {
    const ContactFlow flow(machine, 1e-12 * static_displacement(machine));
    const State state = ContactFlow::state_of(motion);
    const auto modes = flow.modes_of(state);
    for (const ContactMode& mode : modes) EXPECT_EQ(mode.state, SpotState::slip);
    expect_rates(flow, state, modes, static_displacement(machine));
}

// A tip of finite radius rolls while it turns: its approach, and with it the friction bound, has a
// part of second order in the rotation. A machine as heavy as that lifts it out of the rounding.
TEST(ContactFlow, GuardsOfARoundedTipChangeAtTheirRates) {
    Machine machine{.kappas = set_b(),
                    .model = Machine::Model::spots,
                    .spots = {{.position = -1, .tip_radius = 0.6},
                              {.position = 1, .stiffness = 1.3, .tip_radius = 0.4}}};
    machine.kappas.kappa4 = 0.1;
    const double rest = static_displacement(machine);
    Motion motion{.base = 0.05,
                  .z = rest,
                  .phi = 0.002,
                  .x_velocity = 0.05,
                  .z_velocity = 0.003,
                  .phi_velocity = 0.02};
    for (const Spot& spot : machine.spots) {
        const double normal = approach(spot, motion.z, motion.phi / machine.kappas.kappa3);
        motion.spots.push_back({normal, machine.kappas.kappa5 * machine.kappas.kappa2 * normal});
    }
    expect_rates_of_slip(machine, motion);
}

// In the prism the direction of slip turns as the deflection does.
TEST(ContactFlow, GuardsOfATurningSlipChangeAtTheirRates) {
    const Machine machine{.kappas = set_b(), .model = Machine::Model::prism};
    const auto& k = machine.kappas;
    const double rest = static_displacement(machine);
    Motion motion{.base = 2 * rest,
                  .z = 1.2 * rest,
                  .phi = 0.05 * rest,
                  .x_velocity = rest,
                  .z_velocity = 0.4 * rest,
                  .phi_velocity = 0.1 * rest};
    for (const Spot& spot : spots_of(machine)) {
        const double normal = approach(spot, motion.z, motion.phi / k.kappa3) / std::sqrt(2.);
        const double bound = k.kappa5 * k.kappa2 * normal;
        motion.spots.push_back({normal, 0.8 * bound, 0.6 * bound});
    }
    expect_rates_of_slip(machine, motion);
}

}  // namespace
}  // namespace tricontact::walking::contact_flow_test
