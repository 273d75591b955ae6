#include "experiments/identification/loops/loop_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiments/identification/loops/loop_fit.h"

namespace tricontact::experiments::loop_curve_test {
namespace {

constexpr double limit = 3, largest_shift = .7, compliance = .2;  // mu F_N, U_max, 1/k_rig
constexpr int n_nodes = 32;

LoopCurve mindlin(double rig_compliance) {
    std::vector<double> shifts;
    for (int i = 0; i <= n_nodes; ++i)
        shifts.push_back(largest_shift * static_cast<double>(i) / n_nodes);
    return {limit, rig_compliance, shifts};
}

double mindlin_shift(double force) {
    return largest_shift * (1 - std::cbrt(std::pow(1 - force / limit, 2)));
}

/// Mindlin and Deresiewicz (1953), J. Appl. Mech. 20, 327: of a cycle between -F and F, with
/// U_max = 3 (2 - nu) mu F_N/(16 G a) of the pair.
double mindlin_deresiewicz(double force) {
    const double f = force / limit;
    return 24. / 5 * limit * largest_shift *
           (1 - std::pow(1 - f, 5. / 3) - 5 * f / 6 * (1 + std::cbrt(std::pow(1 - f, 2))));
}

// The table of w has 64 nodes: (1/64)^4/384 of the fourth derivative is some 1e-9 of the force, ten
// times that beside a soft rig.
constexpr double tolerance = 1e-7;

TEST(LoopCurve, is_mindlins_with_a_spring_in_series) {
    const LoopCurve curve = mindlin(compliance);
    for (const double force : {.05, .8, 1.9, 2.7, 2.99}) {
        const double shift = mindlin_shift(force) + compliance * force;
        EXPECT_NEAR(curve.at(shift, 1).force, force, tolerance * limit);
        EXPECT_NEAR(curve.at(-shift, 1).force, -force, tolerance * limit);
        // Twice the friction: twice the force at twice the shift.
        EXPECT_NEAR(curve.at(2 * shift, 2).force, 2 * force, 2 * tolerance * limit);
        const double step = 1e-5 * shift;
        EXPECT_NEAR(curve.at(shift, 1).slope,
                    (curve.at(shift + step, 1).force - curve.at(shift - step, 1).force) / 2 / step,
                    1e-5 * curve.at(0, 1).slope);
    }
    EXPECT_NEAR(curve.at(0, 1).slope, 1 / (2 * largest_shift / (3 * limit) + compliance),
                1e-6 * limit / largest_shift);
    EXPECT_DOUBLE_EQ(curve.at(10 * largest_shift, 1).force, limit);
}

TEST(LoopCurve, dissipates_as_mindlin_and_deresiewicz_and_then_4_mu_normal_force) {
    for (const double rig_compliance : {0., compliance}) {
        const LoopCurve curve = mindlin(rig_compliance);
        for (const double force : {.5, 1.5, 2.8})
            EXPECT_NEAR(curve.energy(mindlin_shift(force) + rig_compliance * force, 1),
                        mindlin_deresiewicz(force), 1e-7 * mindlin_deresiewicz(limit));
        const double sliding = curve.sliding_shift();
        EXPECT_NEAR(curve.energy(2 * sliding, 1), mindlin_deresiewicz(limit) + 4 * limit * sliding,
                    1e-7 * mindlin_deresiewicz(limit));
    }
}

TEST(LoopFit, finds_offsets_amplitude_and_friction_of_exact_rows) {
    const LoopCurve curve = mindlin(compliance);
    const double sliding = curve.sliding_shift();
    // Gross slip: both offsets are in the loop.
    const LoopState truth{
        .force_offset = .3, .centre = -.1, .amplitude = 1.6 * sliding, .friction = 1.2};
    MeasuredLoop loop{.n = 60, .centre = truth.centre, .amplitude = .97 * truth.amplitude};
    std::vector<double> shifts;
    std::vector<bool> rises;
    for (int i = 0; i < 60; ++i) {
        shifts.push_back(truth.centre +
                         truth.amplitude * std::cos(2 * std::numbers::pi * (i + .5) / 60));
        rises.push_back(i >= 30);
    }
    const std::vector<double> none(60, 0.);
    const auto forces = loop_of_state({loop, shifts, none, {}, rises}, curve, truth).forces;
    const FittedLoop fit = fit_loop({loop, shifts, forces, {}, rises}, curve, 1, true);
    EXPECT_NEAR(fit.state.force_offset, truth.force_offset, 1e-4 * limit);
    EXPECT_NEAR(fit.state.centre, truth.centre, 1e-4 * truth.amplitude);
    // The extreme shifts, 3 % off, have 1e-3 of the rows' weight.
    EXPECT_NEAR(fit.state.amplitude, truth.amplitude, 1e-4 * truth.amplitude);
    EXPECT_NEAR(fit.state.friction, truth.friction, 1e-4);
}

}  // namespace
}  // namespace tricontact::experiments::loop_curve_test
