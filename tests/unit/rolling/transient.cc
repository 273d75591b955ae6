// Rolling from rest in the moving frame beside the same contact in world-fixed coordinates.

#include <gtest/gtest.h>

#include <cmath>

#include "rolling/run.h"
#include "tests/unit/rolling/problems.h"

namespace tricontact::transient_test {
namespace {

using rolling_test::Rig;

/// A grid on which the contact has room to roll `steps` cells.
std::shared_ptr<const contact::Compliance> long_grid(const Rig& rig, int steps) {
    const int beside = rig.n + 3;
    return bem::half_space_compliance(
        rig.materials(),
        contact::ContactPoints::grid(2 * beside + 1 + steps, 2 * beside + 1,
                                     {-beside * rig.cell(), -beside * rig.cell()},
                                     {rig.cell(), rig.cell()}),
        1);
}

/// Shifts of the loaded sphere in each of its first cells of way, whose points stay where they are.
std::vector<contact::Vector2> shifts_in_fixed_coordinates(const Rig& rig,
                                                          const rolling::RollingProblem& problem,
                                                          int steps) {
    contact::SurfaceModel model("fixed", long_grid(rig, steps), problem.indenter, problem.friction,
                                problem.tolerance);
    contact::LoadStep step;
    step.normal = problem.normal;
    for (int d = 0; d < 2; ++d) step.tangential[d].value = problem.drive.force[d];
    contact::Vector2 before = model.advance(step).shift;
    std::vector<contact::Vector2> shifts;
    for (int k = 1; k <= steps; ++k) {
        step.offset[0] = k * rig.cell();
        const contact::Vector2 now = model.advance(step).shift;
        shifts.push_back({now[0] - before[0], now[1] - before[1]});
        before = now;
    }
    return shifts;
}

// The shift under F_T is that of a contact at rest, and none of what it creeps as it rolls on.
TEST(TransientRolling, CreepsByTheShiftsInFixedCoordinates) {
    constexpr int steps = 4;
    for (const double nu : {.5, .2}) {  // uncoupled, coupled
        Rig rig{.n = 6};
        rig.substrate.poisson = nu;
        rolling::RollingProblem problem = rig.sphere(.6);
        problem.drive.force[1] = -.3 * problem.drive.force[0];
        const auto shifts = shifts_in_fixed_coordinates(rig, problem, steps);
        rolling::TransientRolling rolling(contact::ElasticSubstrate(rig.sphere_grid()), problem);
        EXPECT_EQ(rolling.press().creepage.longitudinal, 0);
        for (const contact::Vector2& shift : shifts) {
            const rolling::Creepage creepage = rolling.roll().creepage;
            // Both solutions converge to the tolerance of mu d; a shift is some hundredth of it.
            EXPECT_NEAR(creepage.longitudinal * rig.cell() / shift[0], 1, 1e-5) << nu;
            EXPECT_NEAR(creepage.lateral * rig.cell() / shift[1], 1, 1e-5) << nu;
        }
    }
}

// Under a prescribed depth, friction of unlike bodies changes F_N; the ratio is that of each state.
TEST(TransientRolling, HasTheForceRatioOfEachStateUnderADepth) {
    Rig rig{.n = 5};
    rig.substrate.poisson = .2;
    rolling::RollingProblem problem = rig.sphere(0);
    problem.normal = {contact::NormalControl::Kind::indentation,
                      rig.half_length * rig.half_length / rig.radius};
    problem.drive.force_ratio = .56;
    problem.tolerance = 1e-7;
    const contact::ElasticSubstrate substrate(rig.sphere_grid());
    const auto states = rolling_test::rolled_from_rest(substrate, problem, 5 * rig.cell());
    ASSERT_EQ(states.size(), 6U);
    const auto steady = rolling::steady_rolling(substrate, problem);
    EXPECT_TRUE(steady.audit.passed());
    double least = steady.state.normal_force, most = least;
    for (const rolling::RollingState& state : states) {
        EXPECT_NEAR(state.force[0] / (rig.friction * state.normal_force), .56, 1e-9);
        least = std::min(least, state.normal_force);
        most = std::max(most, state.normal_force);
    }
    EXPECT_NEAR(steady.state.force[0] / (rig.friction * steady.state.normal_force), .56, 1e-9);
    EXPECT_GT(most / least, 1 + 1e-4);  // there is something to follow
}

}  // namespace
}  // namespace tricontact::transient_test
