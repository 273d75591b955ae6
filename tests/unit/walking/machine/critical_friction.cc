#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/unit/walking/sets.h"
#include "walking/machine/machine.h"

namespace tricontact::walking::critical_friction_test {
namespace {

using Model = Machine::Model;

// Statics: about the leading spot at p the weight kappa4 turns back with the lever p, and the force
// of sliding, which pulls at the height kappa3 (1 + kappa8), turns over.
double due(const Machine& machine, double leading) {
    const Kappas& k = machine.kappas;
    const double force_over_mu = normal_load_factor(machine) * k.kappa4;
    return k.kappa4 * leading / (force_over_mu * k.kappa3 * (1 + k.kappa8));
}

TEST(CriticalFriction, IsWhereTheTrailingSpotLiftsOff) {
    Machine machine{.kappas = set_b()};
    EXPECT_DOUBLE_EQ(critical_friction(machine), due(machine, 1));
    EXPECT_DOUBLE_EQ(critical_friction(machine), critical_friction(machine.kappas));
    machine.model = Model::prism;
    EXPECT_DOUBLE_EQ(critical_friction(machine), due(machine, 1));
    EXPECT_DOUBLE_EQ(critical_friction(machine),
                     critical_friction(machine.kappas) / std::numbers::sqrt2);
    machine.model = Model::spots;
    machine.spots = {{.position = 0.5}, {.position = -1}, {.position = 0.2}};
    EXPECT_DOUBLE_EQ(critical_friction(machine), due(machine, 0.5));
}

TEST(CriticalFriction, IsInfiniteWhereTheSpringPullsBelowTheBase) {
    Machine machine{.kappas = set_b()};
    machine.kappas.kappa8 = -1.2;
    EXPECT_EQ(critical_friction(machine), std::numeric_limits<double>::infinity());
}

// Wetter (2016), set 5: the estimate to three digits.
TEST(Machine, FreeFlightFrequencyIsThatOfTheSpringOnTheBody) {
    const Kappas set_5{2, 1.33, 1.51, 2e-4, 0.75, 1.6e-3, 1.77, -0.47};
    EXPECT_NEAR(free_flight_frequency(set_5), 0.255, 0.0005);
    Kappas centred = set_b();
    centred.kappa8 = 0;  // no rotation: sqrt(kappa1) alone
    EXPECT_DOUBLE_EQ(free_flight_frequency(centred), std::sqrt(2.) / (2 * std::numbers::pi));
}

}  // namespace
}  // namespace tricontact::walking::critical_friction_test
