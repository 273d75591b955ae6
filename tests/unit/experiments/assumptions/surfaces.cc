// Roughness, frictional heating and wear: numbers against closed forms, on each side of their
// thresholds, and not testable without their data.
#include <cmath>

#include "experiments/assumptions/assumption_list.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::surface_assumptions_test {
namespace {

using experiments::Rig;
using experiments::Standing;

Rig sphere() {
    Rig rig;
    rig.R = 40e-3;
    rig.E_1 = experiments::rigid_young;
    rig.nu_1 = .3;
    rig.b = .4;
    rig.E_2 = 5.2e6;
    rig.nu_2 = .5;
    rig.mu = .57;
    rig.F_N = 21.1;
    rig.v = 1e-3;
    rig.w = .25;
    return rig;
}
Rig with(const RigChanges& data) {
    return changed(sphere(), data);
}

constexpr double modulus = 5.2e6 / .75;  // E* of a rigid body on nu = 1/2

// a^2/R = d = 505 um by Hertz.
TEST(SmoothSurfaces, ComparesHeightsWithTheDepth) {
    const double d = std::cbrt(std::pow(.75 * 21.1 / modulus, 2) / 40e-3);
    const auto smooth = experiments::smooth_surfaces(with({{&Rig::h_rms, 5e-6}}));
    EXPECT_EQ(smooth.standing(), Standing::holds);
    EXPECT_NEAR(smooth.deciding_value(), 5e-6 / d, 1e-6 * 5e-6 / d);
    EXPECT_EQ(smooth.consequence.find("wider"), std::string::npos);
    const auto rough = experiments::smooth_surfaces(with({{&Rig::h_rms, 30e-6}}));
    EXPECT_EQ(rough.standing(), Standing::violated);
    EXPECT_NE(rough.consequence.find("wider"), std::string::npos) << rough.consequence;
}

// erf(x) = (2/sqrt(pi)) (x - x^3/3 + ...): 1 - A/A_linear is x^2/3 for small x.
TEST(UnsaturatedContact, IsAThirdOfTheSquareOfSmallPressures) {
    const double a = std::cbrt(.75 * 21.1 * 40e-3 / modulus);
    const double peak = 1.5 * 21.1 / (M_PI * a * a);
    const double slope = 2, x = std::sqrt(2.) * peak / (modulus * slope);
    const auto light = experiments::unsaturated_contact(with({{&Rig::s_rms, slope}}));
    EXPECT_EQ(light.standing(), Standing::holds);
    EXPECT_NEAR(light.deciding_value(), x * x / 3, .01 * x * x / 3);
    EXPECT_EQ(light.consequence.find("lower there"), std::string::npos);
    const auto pressed = experiments::unsaturated_contact(with({{&Rig::s_rms, .1}}));
    EXPECT_EQ(pressed.standing(), Standing::violated);
    EXPECT_NEAR(pressed.background.front().result.value,
                std::erf(std::sqrt(2.) * peak / (modulus * .1)), 1e-6);
    EXPECT_NE(pressed.consequence.find("lower there"), std::string::npos) << pressed.consequence;
}

/// With limits of sliding whose slope has this 95 % interval.
Rig sliding(double slope, double half_width) {
    Rig rig = sphere();
    rig.sliding = experiments::SlidingSlope{.slope = slope,
                                            .standard_error = half_width / 2.2,
                                            .quantile = 2.2,
                                            .n_forces = 12,
                                            .least_load = 1,
                                            .largest_load = 20};
    return rig;
}

// Slope 1 of mu F_N, 2/3 of tau_0 pi a^2 under a sphere.
TEST(FrictionInProportionToPressure, IsJudgedByTheForcesOfFullSliding) {
    const auto coulomb = experiments::unsaturated_contact(sliding(.98, .05));
    EXPECT_EQ(coulomb.standing(), Standing::holds);
    EXPECT_TRUE(coulomb.missing.empty());
    const auto strength = experiments::unsaturated_contact(sliding(.68, .05));
    EXPECT_EQ(strength.standing(), Standing::violated);
    EXPECT_NEAR(strength.deciding_value(), .27, 1e-12);
    // n = 3 m - 2.
    EXPECT_NE(strength.consequence.find("n = 0.040 ± 0.15"), std::string::npos)
        << strength.consequence;
    const auto unclear = experiments::unsaturated_contact(sliding(.84, .2));
    EXPECT_EQ(unclear.standing(), Standing::not_testable);
    EXPECT_NE(unclear.consequence.find("The interval holds both"), std::string::npos);
    // A difference that nobody would notice is none.
    EXPECT_EQ(experiments::unsaturated_contact(sliding(.99, .001)).standing(), Standing::holds);
    // Of a cylinder a shear strength has the slope 1/2: n = 2 m - 1.
    Rig line = sliding(.5, .05);
    line.L = 20e-3;
    line.kind = Rig::Kind::cylinder;
    const auto of_line = experiments::unsaturated_contact(line);
    EXPECT_NE(of_line.consequence.find("n = 0 ± 0.10"), std::string::npos) << of_line.consequence;
}

// Both reasons count: a strength is one where the real area of contact is not saturated.
TEST(FrictionInProportionToPressure, IsViolatedByOneOfBothReasons) {
    Rig rig = sliding(.68, .05);
    rig.s_rms = 2;
    EXPECT_EQ(experiments::unsaturated_contact(rig).standing(), Standing::violated);
    rig = sliding(1, .05);
    rig.s_rms = .1;
    EXPECT_EQ(experiments::unsaturated_contact(rig).standing(), Standing::violated);
}

// A uniform disc source of the power Q: Q/(pi a k), Q = mu F_N v_slip, v_slip = mu a v/R.
TEST(NoHeating, IsBoundedByADiscSourceAtRest) {
    const auto slow = experiments::no_heating(with({{&Rig::k_th, .2}, {&Rig::c_T, 3e-3}}));
    const double a = std::cbrt(.75 * 21.1 * 40e-3 / modulus);
    const double power = .57 * 21.1 * (.57 * a / 40e-3 * 1e-3);
    EXPECT_EQ(slow.standing(), Standing::holds);
    EXPECT_NEAR(slow.background.front().result.value, power / (M_PI * a * .2), 1e-9);
    EXPECT_EQ(slow.consequence.find("bound takes"), std::string::npos);
    const auto fast =
        experiments::no_heating(with({{&Rig::k_th, .2}, {&Rig::c_T, 3e-3}, {&Rig::v, .1}}));
    EXPECT_EQ(fast.standing(), Standing::violated);
    EXPECT_NE(fast.consequence.find("bound takes"), std::string::npos) << fast.consequence;
}

TEST(NoWear, IsArchardsDepthOverTheIndentation) {
    const double a = std::cbrt(.75 * 21.1 * 40e-3 / modulus), d = a * a / 40e-3;
    const double peak = 1.5 * 21.1 / (M_PI * a * a);
    // 1e-5 mm^3/(N m), twelve periods.
    const auto few = experiments::no_wear(with({{&Rig::k_w, 1e-14}, {&Rig::n, 12}}));
    EXPECT_EQ(few.standing(), Standing::holds);
    const double slip = 12 * 4 * .25 * a * .57 * a / 40e-3;
    EXPECT_NEAR(few.deciding_value(), 1e-14 * peak * slip / d, 1e-6 * 1e-14 * peak * slip / d);
    const auto many = experiments::no_wear(with({{&Rig::k_w, 1e-11}, {&Rig::n, 1e5}}));
    EXPECT_EQ(many.standing(), Standing::violated);
    EXPECT_NE(many.consequence.find("bound takes"), std::string::npos) << many.consequence;
}

TEST(SurfaceAssumptions, AreNotTestableWithoutTheirData) {
    EXPECT_EQ(experiments::smooth_surfaces(sphere()).missing,
              std::vector<std::string>{"rig.rms_height"});
    EXPECT_EQ(experiments::unsaturated_contact(sphere()).missing,
              std::vector<std::string>{"rig.rms_slope"});
    EXPECT_EQ(experiments::no_heating(sphere()).missing,
              (std::vector<std::string>{"rig.conductivity", "rig.temperature_coefficient"}));
    EXPECT_EQ(experiments::no_wear(sphere()).missing,
              (std::vector<std::string>{"rig.periods", "rig.wear_rate"}));
}

// A cylinder's pressure and half width are those of its line contact.
TEST(SurfaceAssumptions, OfCylindersAreThoseOfTheLineContact) {
    Rig rig = with({{&Rig::L, 20e-3}, {&Rig::h_rms, 5e-6}, {&Rig::s_rms, .1}});
    rig.kind = Rig::Kind::cylinder;
    const double a = std::sqrt(4 * 21.1 / 20e-3 * 40e-3 / (M_PI * modulus));
    EXPECT_NEAR(experiments::smooth_surfaces(rig).deciding_value(), 5e-6 * 40e-3 / (a * a), 1e-8);
    const double peak = 2 * 21.1 / (M_PI * a * 20e-3);
    EXPECT_NEAR(experiments::unsaturated_contact(rig).background.front().result.value,
                std::erf(std::sqrt(2.) * peak / (modulus * .1)), 1e-8);
}

}  // namespace
}  // namespace tricontact::surface_assumptions_test
