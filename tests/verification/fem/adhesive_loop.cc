// A layer of elements that a ball attracts, pressed and pulled off again.

#include "tests/unit/adhesive_loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/case/model.h"
#include "fem/settings.h"
#include "tests/unit/adhesive_ball.h"

namespace tricontact::fem::fem_adhesive_loop_test {

// What the steps of a run lose in its jumps is what the force works around the loop; on a layer of
// four radii of pull-off, thick enough to jump on coarse elements.
TEST(FemAdhesiveLoop, LosesItsWorkInJumps) {
    test::AdhesiveBall ball(0, 1, .3);
    const double a_off = std::cbrt(1.5) * ball.radius();
    ball.c.layer.thickness = 4 * a_off;
    ball.c.of<Settings>().size = a_off / 3;
    ball.c.of<Settings>().cache = "none";
    const auto model = make_model(ball.c, {});
    const auto [lost, work] = test::energy_of_loop(*model, ball, -2, 1);
    EXPECT_GT(lost, .05 * ball.force() * ball.depth());
    EXPECT_NEAR(lost / work, 1, 1e-3);
}

}  // namespace tricontact::fem::fem_adhesive_loop_test
