#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dynamics/machine.h"
#include "dynamics_sets.h"

namespace tricontact::dynamics {
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

}  // namespace
}  // namespace tricontact::dynamics
