// What planned tables tell of laws of friction, beside least squares by hand and draws of noise.
#include "experiments/design/law_separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tricontact::experiments::law_separation_test {
namespace {

io::RigFile lens(double load_ratio, double tangential_ratio, const char* young = "\"1.8 MPa\"") {
    return io::parse_rig_file(
        "models = [\"mdr\"]\nindenter.shape = \"paraboloid\"\nindenter.radius = \"10 mm\"\n"
        "substrate.young = " +
            std::string(young) +
            "\nsubstrate.poisson = 0.5\nfriction.shear_strength = \"0.35 MPa\"\n"
            "load.normal_force = \"0.5 N\"\nload.tangential_ratio = " +
            std::to_string(tangential_ratio) +
            "\n[design]\nlaws = [\"coulomb\"]\nload_ratio = " + std::to_string(load_ratio) + "\n",
        "lens.toml");
}

// F_lim ~ F_N^(2/3) against mu F_N: with x = F_N/F_lim and equal relative errors s the best mu
// leaves D^2 = (n - (sum x)^2/sum x^2)/s^2. Shifts far below sliding are nearly those of bonded
// contacts under both laws.
TEST(LawSeparation, OfSlidingForcesIsThatOfTwoSlopes) {
    constexpr double error = .05;
    const LawSeparation found = law_separation(
        lens(10, .05), {.laws = {"coulomb"}, .sliding_error = error, .shift_error = .9});
    double sum = 0, squares = 0;
    for (const double exponent : {0., 1. / 6, 1. / 3}) {
        const double x = std::pow(10., -exponent);
        sum += x;
        squares += x * x;
    }
    // Shifts of 90 % error are off by some percent of it.
    EXPECT_NEAR(found.distances[0], std::sqrt(3 - sum * sum / squares) / error, 1e-3 / error);
    ASSERT_EQ(found.rows.size(), 9U);
    // tau_0 pi a^2, a^3 = 3 F_N R/(4 E*), E* = 4/3 E.
    const double a = std::cbrt(3 * .5 * .01 / (4 * 1.8e6 / .75));
    EXPECT_NEAR(found.rows[0].value, .35e6 * std::numbers::pi * a * a, 1e-6);
    EXPECT_NEAR(found.rows[0].standard_error, error * found.rows[0].value, 1e-12);
}

// An E that is not known explains a part of the shifts.
TEST(LawSeparation, IsLessWithUncertainNumbers) {
    const LawPlan plan{.laws = {"coulomb"}, .sliding_error = .03, .shift_error = .02};
    const double known = law_separation(lens(1, .7), plan).distances[0];
    const double unknown = law_separation(lens(1, .7, "\"1.8 ± 0.3 MPa\""), plan).distances[0];
    EXPECT_LT(unknown, .9 * known);
    EXPECT_GT(unknown, 0);
}

TEST(LawSeparation, OfItsOwnLawIsNone) {
    const LawPlan plan{.laws = {"shear-strength", "power", "strength-and-power"},
                       .sliding_error = .03,
                       .shift_error = .02};
    for (const double distance : law_separation(lens(10, .5), plan).distances)
        EXPECT_LT(distance, 1e-3);
}

// Of tables with noise the likelihood ratio exceeds 9.21 in 95 of 100 where D is told_distance.
TEST(LawSeparation, OfTheToldDistanceExcludesInNineteenOfTwenty) {
    const io::RigFile rig = lens(10, .05);
    LawPlan plan{.laws = {"coulomb"}, .sliding_error = .05, .shift_error = .9};
    plan.sliding_error *= law_separation(rig, plan).distances[0] / told_distance;
    plan.laws.emplace_back("shear-strength");
    std::mt19937_64 random(46);
    std::normal_distribution<double> gauss;
    constexpr int n = 300;
    int n_excluded = 0;
    for (int i = 0; i < n; ++i) {
        std::vector<double> noise(9);
        for (double& one : noise) one = gauss(random);
        const auto d = law_separation(rig, plan, noise).distances;
        n_excluded += d[0] * d[0] - d[1] * d[1] > 9.21;
    }
    // 3 sqrt(.95 .05/300) = .038; the linear theory is of small errors.
    EXPECT_NEAR(n_excluded / double(n), .95, .04);
}

}  // namespace
}  // namespace tricontact::experiments::law_separation_test
