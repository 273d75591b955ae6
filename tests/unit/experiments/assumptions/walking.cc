#include <cmath>

#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::walking_test {
namespace {

using enum experiments::PrintedCheck::Agreement;
using experiments::Standing;

void expect_digits(double value, double quoted, double tolerance) {
    EXPECT_NEAR(value / quoted, 1, tolerance) << value << " is not " << quoted;
}

TEST(WalkingRig, GeometryOfTheFiveSets) {
    for (int set = 1; set <= 5; ++set) {
        const auto report = report_of("micro_walking_set_" + std::to_string(set));
        for (const char* name : {"half_height", "half_width", "kappa2", "kappa3"})
            EXPECT_EQ(print_of(report, name).agreement, agrees) << name << ", set " << set;
        EXPECT_EQ(assumption_of(report, "no_tilting").standing(), Standing::holds);
    }
}

TEST(WalkingRig, WeightOfTheLightSetsIsPrintedTooLarge) {
    // kappa_4 = m g/(k_x b): of sets 1 and 3 by three, the others round to the print
    for (const int set : {1, 3}) {
        const auto print =
            print_of(report_of("micro_walking_set_" + std::to_string(set)), "kappa4");
        EXPECT_EQ(print.agreement, differs);
        expect_digits(print.ratio, 2e-4 * 2.216e6 * 0.014 / (0.201 * 9.81), 1e-3);
    }
    for (const int set : {2, 4, 5})
        EXPECT_EQ(
            print_of(report_of("micro_walking_set_" + std::to_string(set)), "kappa4").agreement,
            agrees)
            << set;
}

TEST(WalkingRig, SpringsInSeriesWithTheSensor) {
    const auto polystyrene = report_of("micro_walking_set_1");
    const auto& soft = calculation_of(polystyrene, "spring_stiffness");
    expect_digits(soft.result.value, 2.42e5 / (1 + 2.42e5 / 2e7), 1e-12);
    EXPECT_EQ(print_of(polystyrene, "spring_stiffness").agreement, within_error);
    EXPECT_TRUE(print_of(polystyrene, "spring_stiffness").error_agrees);
    EXPECT_EQ(print_of(polystyrene, "kappa1").agreement, agrees);

    const auto fibre = report_of("micro_walking_set_5");
    const auto& stiff = calculation_of(fibre, "spring_stiffness");
    // s(k_s) = (k_s/k)^2 s(k)
    expect_digits(stiff.result.standard_error, 0.63e6 / std::pow(1 + 5.5e6 / 2e7, 2), 1e-9);
    EXPECT_TRUE(print_of(fibre, "spring_stiffness").error_agrees);
    EXPECT_EQ(print_of(fibre, "kappa1").agreement, agrees);
    EXPECT_EQ(assumption_of(fibre, "rigid_sensor").standing(), Standing::violated);

    const auto spiral = report_of("micro_walking_set_3");
    EXPECT_EQ(value_of(spiral, "spring_stiffness"), 60);
    EXPECT_EQ(print_of(spiral, "kappa1").agreement, differs);
    expect_digits(value_of(spiral, "kappa1"), 60 / 2.216e6, 1e-3);
    EXPECT_EQ(assumption_of(spiral, "similar_stiffness").standing(), Standing::violated);
}

TEST(WalkingRig, ContactDiameterThreeWays) {
    const auto report = report_of("micro_walking_set_5");
    EXPECT_EQ(assumption_of(report, "contact_diameter").standing(), Standing::violated);
    // Johnson (1985), eq. 4.22, a^3 = 3 F R/(4 E*), F = m g/(2 sqrt(2)), for D = 2 a
    const double modulus = 1 / (0.84 / 1.4e9 + 0.91 / 90e9);
    const double force = 0.49 * 9.81 / std::sqrt(8.);
    const double diameter = 2 * std::cbrt(3 * force * 5e-3 / (4 * modulus));
    expect_digits(value_of(report, "hertz_diameter"), diameter, 1e-12);
    const auto& hertz = print_of(report, "hertz_diameter");
    EXPECT_EQ(hertz.agreement, differs);
    // 0.4 mm belongs to about twice the force
    expect_digits(needed(hertz, "F_N") / force, 2, 0.05);
    const auto& frequency = print_of(report, "contact_diameter");
    EXPECT_EQ(frequency.agreement, agrees);
    EXPECT_TRUE(frequency.error_agrees);  // 1.15 mm rounds to 1.2 mm
}

TEST(WalkingRig, ErrorOfTheContactStiffnessIsTwiceThatOfTheTime) {
    const auto report = report_of("micro_walking_set_5");
    EXPECT_EQ(assumption_of(report, "known_stiffness").standing(), Standing::violated);
    expect_digits(value_of(report, "stiffness_error"), 2 * 1.5 / 4.7, 1e-9);
    const auto& stiffness = calculation_of(report, "contact_stiffness").result;
    expect_digits(stiffness.value, 0.49 / (4.7e-4 * 4.7e-4), 1e-12);
    expect_digits(stiffness.standard_error, 1.4e6, 0.02);
    const auto& print = print_of(report, "contact_stiffness");
    EXPECT_EQ(print.agreement, agrees);
    EXPECT_FALSE(print.error_agrees);

    // From the printed means: another value, but this one with the printed error.
    const auto& means = print_of(report, "contact_stiffness_of_means");
    EXPECT_EQ(means.agreement, within_error);
    EXPECT_TRUE(means.error_agrees);
    expect_digits(value_of(report, "contact_stiffness_of_means"), 0.49 * 2400 * 2400, 1e-12);
    const auto& time = calculation_of(report, "characteristic_time").result;
    expect_digits(time.value, 0.1 / 240, 1e-12);
    expect_digits(time.standard_error / time.value, std::hypot(0.06, 62. / 240), 1e-9);
    EXPECT_EQ(print_of(report, "characteristic_time").agreement, within_error);
    EXPECT_FALSE(print_of(report, "characteristic_time").error_agrees);
}

TEST(WalkingRig, TheRodActsAsASpring) {
    const auto report = report_of("micro_walking_set_5");
    EXPECT_EQ(assumption_of(report, "rod_as_spring").standing(), Standing::holds);
    expect_digits(value_of(report, "rod_radius"), 1e-3, 0.01);
    EXPECT_EQ(print_of(report, "rod_radius").agreement, differs);  // printed in mm
    expect_digits(print_of(report, "rod_radius").ratio, 1e-3, 0.01);
    EXPECT_EQ(print_of(report, "beam_force_ratio").agreement, agrees);
    // The moment's ratio is printed upside down; b = 14 mm, r_s = 1 mm
    expect_digits(value_of(report, "beam_moment_ratio"), 0.25 / (14. * 14.), 0.02);
    EXPECT_EQ(print_of(report, "beam_moment_ratio").agreement, differs);
}

TEST(WalkingRig, TheForceIsSampledOftenEnough) {
    const auto report = report_of("micro_walking_set_5");
    EXPECT_EQ(assumption_of(report, "sampled_often").standing(), Standing::holds);
    const auto& rate = print_of(report, "nyquist_rate");
    EXPECT_EQ(rate.agreement, differs);
    expect_digits(rate.ratio, 10, 0.01);
}

}  // namespace
}  // namespace tricontact::walking_test
