#include <gtest/gtest.h>

#include "tests/unit/walking/sets.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/run/walk.h"

namespace tricontact::walking::step_error_test {
namespace {

// Set B on its limit cycle, mu_e = 0.0440 and period 4.293 (Wetter 2016, section 4.2.3), beside a
// run said to have slid steadily with twice that period: four thirds of what the halved step makes
// of it.
TEST(StepError, IsFourThirdsOfWhatHalvingTheStepChanges) {
    constexpr double step = 4e-3;
    const Machine machine{.kappas = set_b()};
    VelocityVerlet run(machine, motion_at_start(machine), step);
    while (run.motion().time < 1500) run.advance();
    WalkResult result{.mu_e = 1, .mu_e_error = 0.1, .period = 2 * 4.293, .period_error = 0.2};
    result.section_points = 1;
    add_step_error(machine, run.motion(), step, result);
    // Printed digits, and the error of the step: of the order of its square.
    EXPECT_NEAR(result.mu_e_error - 0.1, 4. / 3 * (1 - 0.0440), 1e-3);
    EXPECT_NEAR(result.period_error - 0.2, 4. / 3 * 4.293, 2e-3);
}

}  // namespace
}  // namespace tricontact::walking::step_error_test
