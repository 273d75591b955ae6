#include "walking/run/lyapunov.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/walking/sets.h"
#include "walking/machine/event_driven.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::dynamics_lyapunov_test {
namespace {

struct Sample {
    double mean = 0, standard_error = 0;
};

Sample sample_of(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    double sum = 0, squares = 0;
    for (const double value : values) sum += value, squares += value * value;
    const double mean = sum / n;
    return {mean, std::sqrt((squares / n - mean * mean) / (n - 1))};
}

double distance(const Motion& a, const Motion& b) {
    return std::hypot(std::hypot(a.x - b.x, a.z - b.z, a.phi - b.phi),
                      std::hypot(a.x_velocity - b.x_velocity, a.z_velocity - b.z_velocity,
                                 a.phi_velocity - b.phi_velocity));
}

constexpr double aligned_from = 120, aligned_to = 180;

// Without renormalisation, in another integrator: two runs 1e-9 apart at first, which stay below
// 1e-3 in this time.
double rate_by_reference(const Machine& machine, const Start& start) {
    EventDriven run(machine, motion_at_start(machine, start), 1e-12);
    run.advance_to(aligned_from - 20);
    const Motion motion = run.motion();
    Motion neighbour = motion;
    neighbour.x_velocity += 1e-9 * static_displacement(machine);
    EventDriven one(machine, motion, 1e-14), other(machine, neighbour, 1e-14);
    const auto apart_at = [&](double time) {
        one.advance_to(time);
        other.advance_to(time);
        return distance(one.motion(), other.motion());
    };
    const double before = apart_at(aligned_from);
    return std::log(apart_at(aligned_to) / before) / (aligned_to - aligned_from);
}

// The chaotic transient of set B, from sixty starts: renormalised runs of velocity Verlet and
// neighbours left to themselves in the reference integrator grow apart at the same mean rate, to
// three standard errors of its scatter from start to start.
TEST(Lyapunov, AgreesWithNeighboursInTheReferenceIntegrator) {
    const Machine machine{.kappas = set_b()};
    std::vector<double> renormalised, free;
    for (int i = 0; i < 60; ++i) {
        const Start start{.x = 0.05 * i};
        const std::vector<double> rates =
            separation_rates(machine, motion_at_start(machine, start),
                             {.alignment = aligned_from, .duration = aligned_to - aligned_from});
        renormalised.push_back(sample_of(rates).mean);
        free.push_back(rate_by_reference(machine, start));
    }
    const Sample a = sample_of(renormalised), b = sample_of(free);
    EXPECT_NEAR(a.mean, b.mean, 3 * std::hypot(a.standard_error, b.standard_error));
    EXPECT_LT(a.standard_error, 0.01);
    EXPECT_GT(a.mean, 0.1);
}

// What docs/explanation/walking.md says of the transient: sixty starts, those of them that are
// still chaotic half as long after the 300 units of time that count. Their scatter leaves 0.003.
TEST(Lyapunov, IsOneSeventhInTheChaoticTransientOfSetB) {
    const Machine machine{.kappas = set_b()};
    std::vector<double> chaotic;
    for (int i = 0; i < 60; ++i) {
        const std::vector<double> rates =
            separation_rates(machine, motion_at_start(machine, {.x = 0.05 * i}), {.duration = 450});
        const auto after = rates.begin() + 60;
        if (sample_of({after, rates.end()}).mean > 0.06)
            chaotic.push_back(sample_of({rates.begin(), after}).mean);
    }
    const Sample sample = sample_of(chaotic);
    EXPECT_GT(chaotic.size(), 30u);
    EXPECT_NEAR(sample.mean, 0.143, 3 * sample.standard_error);
    EXPECT_LT(sample.standard_error, 0.004);
}

// On its limit cycle only the phase is free, which neither grows nor decays.
TEST(Lyapunov, IsZeroOnTheLimitCycle) {
    const Machine machine{.kappas = set_b()};
    EventDriven run(machine, motion_at_start(machine), 1e-10);
    run.advance_to(16000);
    Motion start = run.motion();
    start.x -= start.base;  // where x is large, its rounding is
    start.base = 0;
    const statistics::Mean found =
        lyapunov_exponent(machine, start, {.alignment = 200, .duration = 1000});
    EXPECT_NEAR(found.value, 0, 0.003);
    EXPECT_LT(found.error, 0.01);
}

}  // namespace
}  // namespace tricontact::walking::dynamics_lyapunov_test
