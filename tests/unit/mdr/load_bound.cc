#include "mdr/load_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "contact/friction/friction.h"

namespace tricontact::mdr_load_bound_test {
namespace {

using mdr::LoadBound;
using mdr::PointRow;
using std::numbers::pi;

constexpr double a = 2e-3, peak = 3e5;  // of Hertz' pressure

/// Line load of p0 sqrt(1 - r^2/a^2) about `middle`, leaning by a part `lean`.
std::vector<double> hertz_load(const PointRow& row, int n, double middle, double lean = 0) {
    std::vector<double> load;
    for (int i = 0; i < n; ++i) {
        const double x = (row.position(i) - middle) / a;
        load.push_back(std::max(0., pi / 2 * peak * a * (1 - x * x) * (1 + lean * x)));
    }
    return load;
}

/// Largest difference of bounds to `expected(x/a)` over b(0), x from the middle.
template <class Expected>
double error(const LoadBound& law, int n, double lean, Expected expected) {
    const PointRow row{-1.3 * a, 2.6 * a / n};
    const double middle = .17 * a;
    const std::vector<double> load = hertz_load(row, n, middle, lean);
    std::vector<double> bound(load.size());
    law.bounds(row, load, bound);
    double largest = 0;
    for (int i = 0; i < n; ++i) {
        if (!(load[i] > 0)) {
            EXPECT_EQ(bound[i], 0);
            continue;
        }
        const double x = (row.position(i) - middle) / a;
        largest = std::max(largest, std::abs(bound[i] - expected(x)));
    }
    return largest / expected(0);
}

// Across a chord of the half length l = a sqrt(1 - x^2/a^2) Hertz' pressure is p0 l/a sqrt(1 -
// y^2/l^2): tau_0 carries 2 l tau_0, c p^n carries l c (p0 l/a)^n B(1/2, 1 + n/2).
double power_on_chord(double n, double x, double share = 1) {
    const double y = std::sqrt(1 - x * x);
    return a * y * std::pow(share * y, n) * std::beta(.5, 1 + n / 2);
}

contact::Friction power_of_pressure(double n) {
    return {.coefficient = .4, .pressure_exponent = n, .reference_pressure = peak};
}

// What is left is the table's, linear between 256 pieces, or 64 where loads may lean: an eighth of
// their squares times a curvature of some 1, 1e-4 at p^3/2.
constexpr double tolerance = 1e-5, tolerance_leaning = 2e-4;

TEST(MdrLoadBound, EvenLoadsHaveTheirBoundsInClosedForm) {
    for (const bool may_lean : {false, true}) {
        const double allowed = may_lean ? tolerance_leaning : tolerance;
        const LoadBound strength(contact::Friction{.shear_strength = 2e5}.law(), may_lean);
        EXPECT_LT(
            error(strength, 200, 0, [](double x) { return 2 * 2e5 * a * std::sqrt(1 - x * x); }),
            allowed);
        for (const double n : {.6, 1.5}) {
            const LoadBound power(power_of_pressure(n).law(), may_lean);
            EXPECT_LT(
                error(power, 200, 0, [&](double x) { return .4 * peak * power_on_chord(n, x); }),
                allowed)
                << n;
        }
    }
}

TEST(MdrLoadBound, LeaningLoadsKeepTheShapeOfTheirChords) {
    const double lean = .3;
    const LoadBound strength(contact::Friction{.shear_strength = 2e5}.law(), true);
    // The ends are extrapolated by a parabola, which leaning loads are not: an error of the second
    // order in the spacing (a/77) that the root at the edge shows most.
    EXPECT_LT(
        error(strength, 200, lean, [](double x) { return 2 * 2e5 * a * std::sqrt(1 - x * x); }),
        1e-3);
    const auto expected = [&](double x) { return .4 * peak * power_on_chord(.6, x, 1 + lean * x); };
    EXPECT_LT(error(LoadBound(power_of_pressure(.6).law(), true), 200, lean, expected),
              tolerance_leaning);
    // By the pressure of the even part alone the lean would be lost.
    EXPECT_GT(error(LoadBound(power_of_pressure(.6).law(), false), 200, lean, expected), .01);
}

// A cone's load falls linearly from the tip, p = slope/pi arcosh(a/r): in all it carries mu F_N and
// the strength of the disc.
TEST(MdrLoadBound, ConesCarryWhatTheirPeakDoes) {
    constexpr int n = 801;
    const double slope = 1e6, mu = .5, strength = 1e5;
    const PointRow row{-1.2 * a, 2.4 * a / n};
    std::vector<double> load, bound(n);
    for (int i = 0; i < n; ++i)
        load.push_back(std::max(0., slope * (a - std::abs(row.position(i)))));
    const auto carried = [&](double tip_slope) {
        LoadBound(contact::Friction{.coefficient = mu, .shear_strength = strength}.law(), false,
                  tip_slope)
            .bounds(row, load, bound);
        return std::accumulate(bound.begin(), bound.end(), 0.) * row.spacing;
    };
    const double exact = mu * slope * a * a + strength * pi * a * a;
    // The innermost piece ends at 0.09 a, and the kink at its middle is a quarter of that too low.
    EXPECT_NEAR(carried(slope) / exact, 1, 1e-3);
}

TEST(MdrLoadBound, NothingPressedCarriesNothing) {
    std::vector<double> bound(5, 1.);
    const LoadBound law(contact::Friction{.shear_strength = 2e5}.law(), true);
    law.bounds({-2, 1}, std::vector<double>(5, 0.), bound);
    EXPECT_EQ(bound, std::vector<double>(5, 0.));
    // A single point is a contact one spacing wide.
    law.bounds({-2, 1}, std::vector<double>{0, 0, 1, 0, 0}, bound);
    EXPECT_NEAR(bound[2] / 2e5, 1, 1e-12);
}

}  // namespace
}  // namespace tricontact::mdr_load_bound_test
