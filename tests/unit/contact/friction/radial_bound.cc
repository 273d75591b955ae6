#include "contact/friction/radial_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tricontact::contact::radial_bound_test {
namespace {

using std::numbers::pi;

std::vector<double> sampled(const RadialBound& radial, double (*of_radius)(double)) {
    std::vector<double> values;
    for (int k = 0; k <= radial.pieces(); ++k) values.push_back(of_radius(radial.radius(k)));
    return values;
}

double height(const RadialBound& radial, int k) {
    return static_cast<double>(k) / radial.pieces();
}

// g = x^2: p = 2/pi sqrt(a^2 - r^2), Hertz (1882); b of tau_0 is that of a chord.
TEST(RadialBound, IsExactForHertzPressureAndAConstantBound) {
    const auto radial = RadialBound::of(64);
    const auto pressure = radial->pressure(sampled(*radial, [](double r) { return 4 * r * r; }), 2);
    const auto chord = radial->line(std::vector(65, 3.), 2);
    for (int k = 0; k <= 64; ++k) {
        EXPECT_NEAR(pressure[k], 2 / pi * 2 * height(*radial, k), 1e-13);
        EXPECT_NEAR(chord[k], 2 * 3 * 2 * height(*radial, k), 1e-13);
    }
}

// h ~ r^4 (Galin 1946): g = x^4, p = 4/pi (r^2 y + y^3/3), y^2 = 1 - r^2. h = r, a cone (Love
// 1939): g = pi/2 x, p = arcosh(1/r)/2, whose line load is pi/2 (1 - x) though p is infinite at the
// tip.
TEST(RadialBound, PressuresOfPowerLawsConverge) {
    double before = 0;
    for (const int n : {64, 128, 256}) {
        const auto radial = RadialBound::of(n);
        const auto pressure =
            radial->pressure(sampled(*radial, [](double r) { return r * r * r * r; }), 1);
        double worst = 0;
        for (int k = 0; k <= n; ++k) {
            const double r = radial->radius(k), y = height(*radial, k);
            worst = std::max(worst, std::abs(pressure[k] - 4 / pi * (r * r * y + y * y * y / 3)));
        }
        // g is linear in x^2 on each piece, and the slope counts as (Y^2 - y^2)^(-1/2).
        if (before > 0) {
            EXPECT_GT(std::log2(before / worst), 1.4) << n;
        }
        before = worst;
    }
    EXPECT_LT(before, 2e-4);
    const auto radial = RadialBound::of(512);
    const auto load = radial->line(
        radial->pressure(sampled(*radial, [](double r) { return pi / 2 * r; }), 1, pi / 2), 1);
    // The last piece carries the mean of a logarithm as a line, and so is off by n^-1/2 at the tip
    // itself, where the load ends in a corner.
    for (int k = 0; k < 512; ++k)
        EXPECT_NEAR(load[k], pi / 2 * (1 - radial->radius(k)), k < 500 ? 1e-4 : 2e-3) << k;
    EXPECT_NEAR(load[512], pi / 2, .025);
}

// tau = y^n: b = y^(n+1) B((n+2)/2, 1/2), of the beta function.
TEST(RadialBound, LinesOfPowersOfThePressureConverge) {
    for (const double n : {.3, 2. / 3, 1., 1.5}) {
        double before = 0;
        for (const int pieces : {128, 256, 512}) {
            const auto radial = RadialBound::of(pieces);
            std::vector<double> bound;
            for (int k = 0; k <= pieces; ++k) bound.push_back(std::pow(height(*radial, k), n));
            const auto line = radial->line(bound, 1);
            double worst = 0;
            for (int k = 0; k <= pieces; ++k)
                worst = std::max(worst, std::abs(line[k] - std::pow(height(*radial, k), n + 1) *
                                                               std::beta((n + 2) / 2, .5)));
            // The singularity of y^n at the edge leaves the order n + 1, where it is below 2.
            if (n != 1 && before > 0) {
                EXPECT_GT(std::log2(before / worst), std::min(n, 1.) + .85);
            }
            EXPECT_LT(worst, n == 1 ? 1e-13 : 2e-3);
            before = worst;
        }
        EXPECT_LT(before, n == 1 ? 1e-13 : n > .5 ? 1e-5 : 1e-4) << n;
    }
}

}  // namespace
}  // namespace tricontact::contact::radial_bound_test
