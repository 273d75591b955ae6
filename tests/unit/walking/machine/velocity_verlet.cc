#include "walking/machine/velocity_verlet.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/unit/walking/sets.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::velocity_verlet_test {
namespace {

struct Normalised {
    double x, z, phi, force;  // x/kappa4, z/zstat, phi/kappa4, f_s/(mu kappa4)
};

Normalised at(double time) {
    const Machine machine{.kappas = set_b()};
    VelocityVerlet run(machine, motion_at_start(machine), 1e-3);
    while (run.motion().time < time - 1e-9) run.advance();
    const Motion& motion = run.motion();
    const double kappa4 = machine.kappas.kappa4;
    return {motion.x / kappa4, motion.z / static_displacement(machine), motion.phi / kappa4,
            spring_force(machine, motion) / (machine.kappas.kappa5 * kappa4)};
}

// An independent program's trajectory, printed to nine decimals.
constexpr double printed = 1e-9;

TEST(VelocityVerlet, FollowsTheReferenceTrajectoryOfSetB) {
    const Normalised five = at(5);
    EXPECT_NEAR(five.x, 4.777833177, printed);
    EXPECT_NEAR(five.z, 1.380395893, printed);
    EXPECT_NEAR(five.phi, -0.100393884, printed);
    EXPECT_NEAR(five.force, 0.305005998, printed);
    const Normalised ten = at(10);
    EXPECT_NEAR(ten.x, 9.435002169, printed);
    EXPECT_NEAR(ten.z, -1.981489490, printed);
    EXPECT_NEAR(ten.phi, -0.534710005, printed);
    EXPECT_NEAR(ten.force, -0.193999924, printed);
}

}  // namespace
}  // namespace tricontact::walking::velocity_verlet_test
