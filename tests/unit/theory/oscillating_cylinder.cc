#include "theory/oscillating_cylinder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tricontact::theory::oscillating_cylinder_test {
namespace {

constexpr double pi = std::numbers::pi;

/// ∫ over (begin, end), whose ends may be like roots or logarithms.
double integral(const std::function<double(double)>& f, double begin, double end) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
    // x = begin + (end - begin) (1 - cos)/2 removes roots.
    return Rule::integrate(
        [&](double angle) {
            const double s = std::sin(angle / 2);
            return f(begin + (end - begin) * s * s) * (end - begin) / 2 * std::sin(angle);
        },
        0., pi, 12, 1e-13);
}

/// F_T/(mu F_N) of a traction over mu p0, F_N/L = pi a p0/2.
double force(const std::function<double(double)>& traction, double w, double c) {
    return 4 / pi * (integral(traction, 0, c) + integral(traction, c, 1 - w));
}

template <class Test>
void over_grid(const Test& test) {
    for (const double w : {.02, .1, .26, .5, .75, .95})
        for (const double share : {1e-3, .05, .3, .6, .9, .999}) test(w, share * (1 - w));
}

TEST(OscillatingCylinder, ForceIsTheIntegralOfTheTraction) {
    over_grid([](double w, double c) {
        const auto tau = [&](double x) { return line_shakedown_traction(x, w, c); };
        EXPECT_NEAR(line_stick_force(w, c), force(tau, w, c), 1e-10) << w << ' ' << c;
    });
}

TEST(OscillatingCylinder, ThesisForceIsTheIntegralOfItsTraction) {
    over_grid([](double w, double c) {
        const auto tau = [&](double x) { return thesis_line_traction(x, w, c); };
        EXPECT_NEAR(thesis_line_stick_force(w, c), force(tau, w, c), 1e-10) << w << ' ' << c;
    });
}

/// What the traction displaces at x, without the constant of the half-space:
/// ∫ tau(s) ln(1/|x - s|) ds 4/pi.
double logarithm(const std::function<double(double)>& traction, double w, double c, double x) {
    const double b = 1 - w;
    // Where tau or the logarithm is not smooth.
    std::vector<double> ends{-b, -c, c, b, std::clamp(x, -b, b)};
    std::sort(ends.begin(), ends.end());
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (ends[i + 1] > ends[i])
            sum += integral([&](double s) { return -traction(s) * std::log(std::abs(x - s)); },
                            ends[i], ends[i + 1]);
    return 2 / pi * sum;
}

// The condition that makes it the solution: what sticks moves as one, by u_sd lambda.
TEST(OscillatingCylinder, WhatSticksIsDisplacedUniformly) {
    constexpr double lambda = 5.8;
    for (const auto& [w, c] : {std::pair(.1, .5), {.26, .3}, {.26, .7}, {.6, .05}, {.6, .35}}) {
        const auto tau = [&, w = w, c = c](double x) { return line_shakedown_traction(x, w, c); };
        const double u = line_settled_shift_ratio(w, c, lambda) * lambda;
        const double constant = line_stick_force(w, c) * (lambda - .5 - std::numbers::ln2);
        for (const double share : {0., .4, .9})
            EXPECT_NEAR(constant + logarithm(tau, w, c, share * c), u, 1e-8)
                << w << ' ' << c << ' ' << share;
    }
}

// Superposed punches, and the logarithm of Flamant's line force over the traction itself.
TEST(OscillatingCylinder, DisplacementBesideTheStickZone) {
    constexpr double lambda = 5.8;
    for (const auto& [w, c] : {std::pair(.1, .5), {.26, .3}, {.26, .7}, {.6, .05}, {.77, .2}}) {
        const auto tau = [&, w = w, c = c](double x) { return line_shakedown_traction(x, w, c); };
        const double constant = line_stick_force(w, c) * (lambda - .5 - std::numbers::ln2);
        for (const double x : {0., .9 * c, .5 * (c + 1 - w), -(1 - w), 1., -1.7})
            EXPECT_NEAR(line_shakedown_displacement(x, w, c, lambda) * lambda,
                        constant + logarithm(tau, w, c, x), 1e-8)
                << w << ' ' << c << ' ' << x;
    }
}

// 4 W of Carter's creepage mu a/R (1 - sqrt(1 - f)) over U_max = mu a^2/(2 R) lambda.
TEST(OscillatingCylinder, SteadySlopeIsCartersCreepage) {
    const double mu = .79, a = 2.07e-3, R = .04, f = .51, lambda = 5.85, W = 3 * a;
    const double shift = 4 * W * mu * a / R * (1 - .7);  // sqrt(1 - .51) = .7
    EXPECT_NEAR(line_steady_slope(f, lambda) * W / a, shift / (mu * a * a / (2 * R) * lambda),
                1e-13);
    EXPECT_EQ(line_steady_slope(0, lambda), 0);
}

// Entries of docs/explanation/cylinder.md, by elements on the rig: L/a = 38.6, so that (a/L)^2 =
// 7e-4 remains.
TEST(OscillatingCylinder, TableOfSettledShifts) {
    struct Entry {
        double w, f, shift, error;
    };
    const double ratio = 38.652;  // 80 mm over Hertz' half width
    const double lambda = .5 + std::numbers::ln2 + std::log(ratio) + 1;  // nu = 1/2
    for (const Entry& e : {Entry{.26, .3, .29702, 2e-5},
                           {.26, .65, .67979, 1.1e-4},
                           {.52, .36, .40530, 1.8e-4},
                           {.77, .12, .14954, 8e-5}}) {
        const double c = line_stick_half_width(e.w, e.f).value();
        EXPECT_NEAR(line_settled_shift_ratio(e.w, c, lambda), e.shift, e.error)
            << e.w << ' ' << e.f;
    }
}

// The difference of two ellipses does not, by (c/b)^2 of the shift: up to a percent of f_T.
TEST(OscillatingCylinder, ThesisTractionIsAnApproximation) {
    const double w = .26, c = .37;
    const auto tau = [&](double x) { return thesis_line_traction(x, w, c); };
    EXPECT_GT(std::abs(logarithm(tau, w, c, 0) - logarithm(tau, w, c, .9 * c)), 1e-4);
    double largest = 0;
    over_grid([&](double rolled, double stuck) {
        const double ratio =
            thesis_line_stick_force(rolled, stuck) / line_stick_force(rolled, stuck) - 1;
        EXPECT_GE(ratio, -1e-9) << rolled << ' ' << stuck;
        largest = std::max(largest, ratio);
    });
    EXPECT_GT(largest, .009);
    EXPECT_LT(largest, .014);
    // It is exact in both limits.
    EXPECT_NEAR(thesis_line_stick_force(.3, 1e-7), line_shakedown_limit(.3), 1e-7);
    for (const double stuck : {.2, .7})
        EXPECT_NEAR(thesis_line_stick_force(0, stuck), line_stick_force(0, stuck), 1e-12);
}

TEST(OscillatingCylinder, WithoutRollingItIsCattaneos) {
    for (const double f : {.05, .3, .8, .99}) {
        const double c = std::sqrt(1 - f);  // (3.5.4)
        EXPECT_NEAR(line_stick_half_width(0, f).value(), c, 1e-12);
        for (const double x : {0., .5 * c, .99 * c, .5 + .5 * c})
            EXPECT_NEAR(line_shakedown_traction(x, 0, c),
                        std::sqrt(1 - x * x) - (x < c ? std::sqrt(c * c - x * x) : 0), 1e-10);
        EXPECT_NEAR(line_static_shift_ratio(f, 4.7), line_settled_shift_ratio(0, c, 4.7), 1e-10);
    }
    EXPECT_NEAR(line_static_shift_ratio(1, 3), 1, 1e-15);
}

// (1/F_N) ∫ min p dx of the half ellipse; the stick width's vanishing gives the same.
TEST(OscillatingCylinder, LimitIsTheLeastPressure) {
    for (const double w : {0., .1, .4, .75, 1.}) {
        const auto least = [&](double x) { return std::sqrt(std::max(0., 1 - (x + w) * (x + w))); };
        EXPECT_NEAR(line_shakedown_limit(w), 4 / pi * integral(least, 0, 1 - w), 1e-10) << w;
        EXPECT_NEAR(line_shakedown_limit(w), line_stick_force(w, 0), 1e-10) << w;
        EXPECT_NEAR(line_amplitude_limit(line_shakedown_limit(w)), w, 1e-7) << w;
    }
}

TEST(OscillatingCylinder, StickWidthIsTheInverse) {
    over_grid([](double w, double c) {
        EXPECT_NEAR(line_stick_half_width(w, line_stick_force(w, c)).value(), c, 1e-7);
        const double f = thesis_line_stick_force(w, c);
        if (f <= line_shakedown_limit(w)) {
            EXPECT_NEAR(thesis_line_stick_half_width(w, f).value(), c, 1e-6) << w << ' ' << c;
        }
    });
    EXPECT_FALSE(line_stick_half_width(.3, line_shakedown_limit(.3) + 1e-6));
    EXPECT_NEAR(line_stick_half_width(.3, line_shakedown_limit(.3)).value(), 0, 1e-5);
    EXPECT_EQ(line_stick_half_width(1, 0).value(), 0);
}

// Masing: the loop of the virgin curve U(F), 4 F U - 8 ∫ U dF, in mu F_N U_max/lambda.
TEST(OscillatingCylinder, CycleDissipation) {
    const double lambda = 5;
    for (const double f : {5e-4, .1, .5, .9, 1.}) {
        const auto u = [&](double x) { return line_static_shift_ratio(x, lambda); };
        const double loop = lambda * (4 * f * u(f) - 8 * integral(u, 0, f));
        EXPECT_NEAR(line_cycle_dissipation(f), loop, 1e-11) << f;
    }
}

// The thesis' fits beside what they were fitted to, to their own accuracy.
TEST(OscillatingCylinder, FitsOfTheThesis) {
    // The rig's factor: L/a = 80/2.07, nu = 1/2.
    const double lambda = .5 + std::numbers::ln2 + std::log(80 / 2.07) + 1;
    for (const double f : {.1, .4, .8})
        EXPECT_NEAR(thesis_line_static_shift_ratio(f), line_static_shift_ratio(f, lambda), 3e-3);
    for (const double w : {.1, .26, .5, .75}) {
        const double limit = line_shakedown_limit(w);
        EXPECT_NEAR(thesis_line_amplitude_limit(limit), w, 1e-2);
        EXPECT_NEAR(thesis_line_limit_shift_ratio(limit), line_settled_shift_ratio(w, 0, lambda),
                    6e-3);
        for (const double share : {.2, .5, .8}) {
            const double f = share * limit, c = line_stick_half_width(w, f).value();
            EXPECT_NEAR(thesis_line_settled_shift_ratio(w, f).value(),
                        line_settled_shift_ratio(w, c, lambda), 1.2e-2)
                << w << ' ' << share;
        }
    }
}

TEST(OscillatingCylinder, RefusesArgumentsOutOfRange) {
    EXPECT_THROW(line_stick_force(-.1, .2), std::domain_error);
    EXPECT_THROW(line_stick_force(.5, .6), std::domain_error);
    EXPECT_THROW(line_stick_half_width(.5, 1.1), std::domain_error);
    EXPECT_THROW(line_settled_shift_ratio(.5, .2, 0), std::domain_error);
    EXPECT_THROW(line_shakedown_limit(std::nan("")), std::domain_error);
    EXPECT_THROW(thesis_line_traction(0, .5, .5), std::domain_error);
    EXPECT_THROW(thesis_line_increment(2, .5), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::oscillating_cylinder_test
