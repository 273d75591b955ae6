#include <gtest/gtest.h>

#include "tests/unit/walking/sets.h"
#include "walking/machine/motion.h"
#include "walking/machine/stretch_recorder.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::spot_view_test {
namespace {

TEST(SpotView, HasTheForcesOfTheBeds) {
    const Machine machine{.kappas = set_b(),
                          .model = Machine::Model::spots,
                          .spots = {{.position = -1, .stiffness = 0.7},
                                    {.position = 0.3, .height = 1e-5, .stiffness = 2},
                                    {.position = 1}},
                          .bed = Bed{.radius = 0.3, .springs = 24}};
    const std::vector<Spot> spots = spots_of(machine);
    VelocityVerlet run(machine, motion_at_start(machine), 1e-3);
    SpotView view(machine);
    for (int i = 0; i < 4000; ++i) {
        run.advance();
        view.look_at(run.motion(), run.spot_steps());
        ASSERT_EQ(view.motion().spots.size(), 3u);
        for (std::size_t spot = 0; i % 100 == 0 && spot < 3; ++spot) {
            SpotForce sum;
            for (std::size_t j = 24 * spot; j < 24 * (spot + 1); ++j) {
                const SpotForce force = spot_force(machine, run.spots()[j], run.motion().spots[j]);
                sum.normal += force.normal;
                sum.tangential += force.tangential;
            }
            const SpotForce seen = spot_force(machine, spots[spot], view.motion().spots[spot]);
            EXPECT_NEAR(seen.normal, sum.normal, 1e-18);  // rounding: forces of 1e-4
            EXPECT_NEAR(seen.tangential, sum.tangential, 1e-18);
        }
    }
}

TEST(SpotView, SticksWhileOneSpringDoes) {
    const Machine machine{.kappas = set_b(), .bed = Bed{.radius = 0.3, .springs = 3, .width = 1}};
    Motion motion = motion_at_start(machine);
    motion.spots = {{0}, {1}, {1}, {0}, {0}, {0}};
    SpotView view(machine);
    std::vector<SpotStep> steps(6);
    steps[1] = {.sticks = true};
    steps[2] = {.sticks = false, .slip = 2};
    view.look_at(motion, steps);
    EXPECT_TRUE(view.steps()[0].sticks);
    EXPECT_EQ(view.steps()[0].slip, 0);
    steps[1] = {.sticks = false, .slip = -1};
    view.look_at(motion, steps);
    EXPECT_FALSE(view.steps()[0].sticks);
    EXPECT_EQ(view.steps()[0].slip, -1);
    EXPECT_EQ(view.motion().spots[1].normal, 0);  // in the air
}

TEST(SpotView, WithoutABedIsTheRun) {
    const Machine machine{.kappas = set_b()};
    VelocityVerlet run(machine, motion_at_start(machine), 1e-3);
    SpotView view(machine);
    view.look_at(run.motion(), run.spot_steps());
    EXPECT_EQ(&view.motion(), &run.motion());
}

}  // namespace
}  // namespace tricontact::walking::spot_view_test
