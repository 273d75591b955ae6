#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/creep_law.h"

namespace tricontact::theory::free_rolling_test {
namespace {

TEST(FreeRolling, ChangesItsSignWithTheBodies) {
    for (const double beta : {0., .1, .3, .5}) {
        EXPECT_EQ(rough_free_creepage(-beta), -rough_free_creepage(beta));
        EXPECT_EQ(smooth_free_creepage(-beta), -smooth_free_creepage(beta));
    }
    EXPECT_EQ(rough_free_creepage(0), 0);
}

// To the first order in beta the pressure stays Hertz'. Tractions that are bounded at both edges
// undo its stretch 2 beta p/E* but for the mean of it weighted by 1/sqrt(a^2 - x^2), (2/pi) 2 beta
// p0/E*, which is the creepage: xi = 2 beta/pi a/R.
TEST(FreeRolling, WithoutSlipIsItsLinearTheoryForAlikeBodies) {
    for (const double beta : {1e-3, 2e-3})
        EXPECT_NEAR(rough_free_creepage(beta) / (2 * beta / std::numbers::pi), 1, beta * beta);
}

// .404 of the half width carry half of the load.
TEST(FreeRolling, WithSlipEverywhereHalfOfTheLoadSlipsEitherWay) {
    const double cosine = smooth_free_creepage(.5) / .5, y = std::sqrt(1 - cosine * cosine);
    EXPECT_NEAR(y, .404, 5e-4);
    EXPECT_NEAR((std::asin(y) + y * cosine) / (std::numbers::pi / 2), .5, 1e-12);
}

TEST(FreeRolling, CreepsMoreWithSlip) {
    for (const double beta : {.05, .2, .5})
        EXPECT_LT(rough_free_creepage(beta), smooth_free_creepage(beta));
    EXPECT_THROW(rough_free_creepage(.76), std::domain_error);
    EXPECT_THROW(smooth_free_creepage(std::nan("")), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::free_rolling_test
