// What the jumps of a loop lose is what the force works around it, by cells.

#include "tests/unit/adhesive_loop.h"

#include <gtest/gtest.h>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/cells.h"

namespace tricontact::bem_adhesive_loop_test {
namespace {

void expect_closed(double lambda, double cells, bem::Body body) {
    test::AdhesiveBall ball(lambda, 1);
    ball.c.of<contact::Cells>().spacing = ball.radius() / cells;
    if (body == bem::Body::layer) ball.c.layer.thickness = 2 * ball.radius();
    const auto model = bem::make_model(ball.c, 1, body);
    const auto [lost, work] = test::energy_of_loop(*model, ball, -2, 1);
    EXPECT_GT(lost, .05 * ball.force() * ball.depth());
    EXPECT_NEAR(lost / work, 1, 1e-3) << lambda;
    EXPECT_TRUE(model->audit().passed());
}

TEST(BemAdhesiveLoop, ClosesOnTheHalfSpace) {
    expect_closed(0, 5, bem::Body::half_space);
    expect_closed(1, 5, bem::Body::half_space);
}

TEST(BemAdhesiveLoop, ClosesOnALayer) {
    expect_closed(0, 6, bem::Body::layer);
}

}  // namespace
}  // namespace tricontact::bem_adhesive_loop_test
