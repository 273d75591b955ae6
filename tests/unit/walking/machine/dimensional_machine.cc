#include "walking/machine/dimensional_machine.h"

#include <gtest/gtest.h>

#include "tests/unit/walking/sets.h"

namespace tricontact::walking::dimensional_machine_test {
namespace {

TEST(DimensionalMachine, OfKappasHasThem) {
    const Kappas there = set_b();
    const Kappas back = kappas_of(with_dimensions(there, 0.49, 14e-3));
    constexpr double rounding = 1e-14;
    EXPECT_NEAR(back.kappa1 / there.kappa1, 1, rounding);
    EXPECT_NEAR(back.kappa2 / there.kappa2, 1, rounding);
    EXPECT_NEAR(back.kappa3 / there.kappa3, 1, rounding);
    EXPECT_NEAR(back.kappa4 / there.kappa4, 1, rounding);
    EXPECT_EQ(back.kappa5, there.kappa5);
    EXPECT_NEAR(back.kappa6 / there.kappa6, 1, rounding);
    EXPECT_NEAR(back.kappa7 / there.kappa7, 1, rounding);
    EXPECT_NEAR(back.kappa8 / there.kappa8, 1, rounding);
}

// Wetter (2016), set 5 (tables 4.3.2 and 5.2.1, eq. 5.2.33) as printed, to its last digits: the
// rig's k_x is one digit, so kappa4 and kappa6 are.
TEST(DimensionalMachine, HasTheKappasOfTheRig) {
    const DimensionalMachine rig{.mass = 0.49,
                                 .half_height = 21.2e-3,
                                 .half_width = 14e-3,
                                 .moment_of_inertia = 1.77 * 0.49 * 14e-3 * 14e-3,
                                 .spring_stiffness = 4.34e6,
                                 .normal_stiffness = 1.33 * 2.2e6,
                                 .tangential_stiffness = 2.2e6,
                                 .friction_coefficient = 0.75,
                                 .base_velocity = 47e-3,
                                 .lever_arm = -0.47 * 21.2e-3};
    const Kappas kappas = kappas_of(rig);
    EXPECT_NEAR(kappas.kappa1, 2, 0.05);
    EXPECT_NEAR(kappas.kappa3, 1.51, 0.005);
    EXPECT_NEAR(kappas.kappa4, 2e-4, 0.5e-4);
    EXPECT_NEAR(kappas.kappa6, 1.6e-3, 0.05e-3);
    EXPECT_NEAR(kappas.kappa8, -0.47, 1e-12);
    EXPECT_NEAR(characteristic_time(rig), 4.7e-4, 0.05e-4);
}

}  // namespace
}  // namespace tricontact::walking::dimensional_machine_test
