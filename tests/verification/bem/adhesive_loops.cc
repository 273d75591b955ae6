// Cells that attract each other, pressed and pulled off again.

#include <gtest/gtest.h>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/cells.h"
#include "tests/unit/adhesive_ball.h"
#include "tests/unit/adhesive_loop.h"
#include "theory/adhesive/maugis_dugdale.h"

namespace tricontact::bem::bem_adhesive_loops_test {
namespace {

using test::AdhesiveBall;

// Dugdale's tension over a ring of three cells, pressed and pulled: fronts are not held by cells,
// so that states on the way up and down are the same, and the errors are those of the ring's edge.
TEST(BemAdhesiveLoops, ShortRangeIsNotHeldByCells) {
    AdhesiveBall ball(3, 1.1);
    ball.c.of<contact::Cells>().spacing = ball.radius() / 40;
    ball.c.of<bem::Settings>().tolerance = 1e-5;
    const auto model = bem::make_model(ball.c, 1);
    ball.press(*model, 1.1);
    for (const double depth : {1., .9, 1.}) {
        const double force = ball.press(*model, depth).normal_force / ball.force();
        EXPECT_NEAR(force, theory::maugis_contact_at(3, depth).force, 9e-3) << depth;
        if (depth == 1) {
            static double first = force;
            EXPECT_NEAR(force, first, 5e-4);
        }
    }
}

// What the steps of a run lose in its jumps is what the force works around the loop.
TEST(BemAdhesiveLoops, LoopLosesItsWorkInJumps) {
    const auto expect_closed = [](double lambda, double cells, bem::Body body) {
        AdhesiveBall ball(lambda, 1);
        ball.c.of<contact::Cells>().spacing = ball.radius() / cells;
        if (body == bem::Body::layer) ball.c.layer.thickness = 2 * ball.radius();
        const auto model = bem::make_model(ball.c, 1, body);
        const auto [lost, work] = test::energy_of_loop(*model, ball, -2, 1);
        EXPECT_GT(lost, .05 * ball.force() * ball.depth());
        EXPECT_NEAR(lost / work, 1, 1e-3) << lambda;
        EXPECT_TRUE(model->audit().passed());
    };
    expect_closed(0, 5, bem::Body::half_space);
    expect_closed(1, 5, bem::Body::half_space);
    expect_closed(0, 6, bem::Body::layer);
}

}  // namespace
}  // namespace tricontact::bem::bem_adhesive_loops_test
