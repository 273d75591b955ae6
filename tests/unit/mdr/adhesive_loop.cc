// What the jumps of a loop lose is what the force works around it, by springs.

#include "tests/unit/adhesive_loop.h"

#include <gtest/gtest.h>

#include "mdr/layer_model.h"
#include "mdr/model.h"

namespace tricontact::mdr_adhesive_loop_test {

TEST(MdrAdhesiveLoop, ClosesWithAndWithoutARangeAndOnALayer) {
    const auto expect_closed = [](contact::Model& model, const test::AdhesiveBall& ball) {
        const auto [lost, work] = test::energy_of_loop(model, ball, -2, 1);
        EXPECT_GT(lost, .05 * ball.force() * ball.depth());
        EXPECT_NEAR(lost / work, 1, 1e-3);
        EXPECT_TRUE(model.audit().passed());
    };
    for (const double lambda : {0., 3., 1.}) {
        const test::AdhesiveBall ball(lambda, 1);
        expect_closed(*mdr::make_model(ball.c), ball);
    }
    for (const double nu : {.3, .5}) {
        test::AdhesiveBall ball(0, 1, nu);
        ball.c.layer.thickness = ball.radius();
        expect_closed(*mdr::make_layer_model(ball.c), ball);
    }
}

}  // namespace tricontact::mdr_adhesive_loop_test
