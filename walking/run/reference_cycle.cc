#include "walking/run/reference_cycle.h"

#include <algorithm>

#include "contact/error.h"

namespace tricontact::walking {

namespace {

constexpr double patience = 1000;

bool flies(const EventDriven& run) {
    return std::none_of(run.modes().begin(), run.modes().end(),
                        [](const ContactMode& mode) { return mode.touches; });
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

EnergyBalance difference(const EnergyBalance& after, const EnergyBalance& before) {
    return {.base = after.base - before.base,
            .excitation = after.excitation - before.excitation,
            .geometric = after.geometric - before.geometric,
            .dissipation = after.dissipation - before.dissipation,
            .stored = after.stored - before.stored};
}

}  // namespace

ReferenceCycle reference_cycle(EventDriven& run) {
    const std::size_t n_spots = run.modes().size();
    ReferenceCycle before{.stick_times = std::vector<double>(n_spots)};
    follow_to_flight(run, before);
    const EnergyBalance balance = run.energy_balance();
    ReferenceCycle cycle{.start = run.motion(),
                         .stick_times = std::vector<double>(n_spots),
                         .z_min = run.motion().z};
    follow_to_flight(run, cycle);
    for (double& time : cycle.stick_times) time /= cycle.period;
    cycle.balance = difference(run.energy_balance(), balance);
    // The work of the base is its way times the mean force.
    cycle.spring_force = cycle.balance.base / (run.motion().base - cycle.start.base);
    return cycle;
}

}  // namespace tricontact::walking
