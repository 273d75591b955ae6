#include "theory/friction_pressing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tricontact::theory::friction_pressing_test {
namespace {

// At c/a = 1/sqrt(2), ln[(a + c)/(a - c)] = 2 ln(1 + sqrt(2)) and K = Gamma(1/4)^2/(4 sqrt(pi))
// (the lemniscatic case).
TEST(FrictionPressing, StickRadiusWhereTheIntegralIsKnown) {
    const double k = std::pow(std::tgamma(.25), 2) / (4 * std::sqrt(std::acos(-1.)));
    const double beta_over_mu = k / (std::sqrt(2) * std::log(1 + std::sqrt(2)));
    EXPECT_NEAR(spence_stick_ratio(beta_over_mu), std::sqrt(.5), 1e-13);
}

TEST(FrictionPressing, MoreFrictionSticksMore) {
    EXPECT_LT(spence_stick_ratio(2), spence_stick_ratio(1));
    EXPECT_LT(spence_stick_ratio(100), 2e-7);
    EXPECT_GT(spence_stick_ratio(.01), 1 - 1e-12);
}

TEST(FrictionPressing, StiffnessWithoutSlip) {
    EXPECT_NEAR(stuck_normal_stiffness_ratio(0), std::log(3), 1e-15);
    EXPECT_NEAR(stuck_normal_stiffness_ratio(.5 - 1e-9), 2, 1e-8);  // as without friction
}

TEST(FrictionPressing, ArgumentsOutOfRange) {
    EXPECT_THROW(spence_stick_ratio(0), std::domain_error);
    EXPECT_THROW(spence_stick_ratio(INFINITY), std::domain_error);
    EXPECT_THROW(stuck_normal_stiffness_ratio(.5), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::friction_pressing_test
