#include "theory/torsion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::torsion_test {
namespace {

// All slips: the torque of mu p over the disc, int mu p r dA = 3 pi/16 mu F_N a.
TEST(Torsion, SlidesUnderTheTorqueOfAllFriction) {
    EXPECT_NEAR(theory::torque_ratio(0), 3 * std::numbers::pi / 16, 1e-10);
}

// Reissner and Sagoci: M = 16/3 G a^3 beta of a punch that sticks. The slip annulus takes a share
// of the order of 1 - c^2/a^2, here 1e-4.
TEST(Torsion, SticksAtFirst) {
    const double c = std::sqrt(1 - 1e-4);
    EXPECT_NEAR(theory::torque_ratio(c) / theory::twist_ratio(c), 16. / 3, 16. / 3 * 1.5e-4);
    EXPECT_EQ(theory::torque_ratio(1), 0);
    EXPECT_EQ(theory::twist_ratio(1), 0);
}

// Deresiewicz (1954, J. Appl. Mech. 21, 327) approximates the curve: beta G a^2/(mu F_N) =
// (1/8) [1 - (1 - 3/2 m)^(1/2)] [3 - (1 - 3/2 m)^(1/2)], m = M/(mu F_N a), good to the second
// order in m: what is missing falls with m^2.
TEST(Torsion, HasTheSecondOrderOfDeresiewicz) {
    const auto missing = [](double c) {
        const double root = std::sqrt(1 - 1.5 * theory::torque_ratio(c));
        return std::abs((1 - root) * (3 - root) / 8 / theory::twist_ratio(c) - 1);
    };
    const double order = std::log(missing(.98) / missing(.99)) /
                         std::log(theory::torque_ratio(.98) / theory::torque_ratio(.99));
    EXPECT_NEAR(order, 2, .05);
    EXPECT_LT(missing(.9), .01);
}

TEST(Torsion, RefusesWhatIsNoStickRadius) {
    EXPECT_THROW(theory::twist_ratio(0), std::domain_error);
    EXPECT_THROW(theory::twist_ratio(1.1), std::domain_error);
    EXPECT_THROW(theory::torque_ratio(-.1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::torsion_test
