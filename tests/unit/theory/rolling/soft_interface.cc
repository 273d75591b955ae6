#include "theory/rolling/soft_interface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::soft_interface_test {
namespace {

/// What springs in the plane carry by the midpoint rule: least bound of both extremes or `u`.
double carried(double w, double u) {
    constexpr int n = 1500;
    constexpr double h = 1. / n;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = (i + .5) * h, y = (j + .5) * h;  // a quarter: both axes of symmetry
            sum += std::min(u, std::max(0., 1 - (x + w) * (x + w) - y * y));
        }
    return 4 * h * h * sum / (std::numbers::pi / 2);
}

// The midpoint rule leaves h^2 of a kink's length: below 1e-6.
TEST(SoftInterface, CarriesWhatSpringsInThePlaneDo) {
    for (const double w : {0., .2, .45})
        for (const double u : {.1, .35, .8})
            EXPECT_NEAR(theory::soft_interface_settled_force(w, u), carried(w, u), 2e-6)
                << w << ' ' << u;
    for (const double w : {.1, .2, .6})
        EXPECT_NEAR(theory::soft_interface_limit(w), carried(w, 1), 2e-6) << w;
}

TEST(SoftInterface, HasItsLimitCases) {
    for (const double u : {0., .3, 1.})
        EXPECT_NEAR(theory::soft_interface_settled_force(0, u), theory::soft_interface_force(u),
                    1e-15);
    EXPECT_EQ(theory::soft_interface_limit(0), 1);
    EXPECT_EQ(theory::soft_interface_limit(1), 0);
    EXPECT_EQ(theory::soft_interface_settled_force(.3, 1), theory::soft_interface_limit(.3));
    EXPECT_THROW(theory::soft_interface_limit(1.1), std::domain_error);
    EXPECT_THROW(theory::soft_interface_force(-.1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::soft_interface_test
