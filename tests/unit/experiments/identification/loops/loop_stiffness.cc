#include "experiments/identification/loops/loop_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tricontact::experiments::loop_stiffness_test {

namespace {

constexpr double stiffness = 3e6, slide = 2e-6, centre = 1e-6, amplitude = 10e-6;

/// A spring that slips at a bound, from reversal to reversal: F = k (U - U_r) - k slide, then k
/// slide. Rows at unlike places, offsets in both.
struct Spring {
    MeasuredLoop loop{.n = 60, .centre = centre, .amplitude = amplitude};
    std::vector<double> shifts, forces, errors;
    std::vector<bool> rises;

    Spring() {
        for (std::size_t i = 0; i < loop.n; ++i) {
            const double phase = 2 * std::numbers::pi * (static_cast<double>(i) + .3) / 60;
            const double u = -amplitude * std::cos(phase);
            const bool up = phase < std::numbers::pi;
            const double way = up ? u + amplitude : amplitude - u;
            shifts.push_back(centre + u);
            forces.push_back(7 + (up ? 1 : -1) * stiffness * std::min(way - slide, slide));
            errors.push_back(.5);
            rises.push_back(up);
        }
    }
    LoopRows rows() const { return {loop, shifts, forces, errors, rises}; }
};

}  // namespace

// Both are exact for straight parts of a loop, wherever force and shift count from.
TEST(LoopStiffness, IsThatOfASpringThatSlips) {
    const Spring spring;
    const LoopRows rows = spring.rows();
    const auto initial = initial_stiffness(rows, slide / amplitude);
    ASSERT_TRUE(initial);
    EXPECT_NEAR(weighted(*initial, rows.forces), stiffness, 1e-9 * stiffness);
    // Rows of the last twentieth lie up to 5 % of the way before the reversals.
    const double secant = weighted(secant_stiffness(rows), rows.forces);
    const double exact = stiffness * slide / amplitude;
    EXPECT_GT(secant, exact);
    EXPECT_LT(secant, 1.05 * exact);
}

TEST(LoopStiffness, NeedsThreeRowsBehindAReversal) {
    const Spring spring;
    EXPECT_FALSE(initial_stiffness(spring.rows(), 1e-3));
}

// Of a line through n rows sigma_F/sqrt(sum (U - mean U)^2), of two branches the mean.
TEST(LoopStiffness, HasTheErrorOfItsRows) {
    const Spring spring;
    const LoopRows rows = spring.rows();
    const double part = .3;
    double variance = 0;
    for (const bool rises : {true, false}) {
        double n = 0, mean = 0, squares = 0;
        for (const int pass : {0, 1})
            for (std::size_t i = 0; i < rows.shifts.size(); ++i) {
                const double u = rows.shifts[i] - centre;
                const double way = (amplitude + (rises ? u : -u)) / amplitude / 2;
                if (rows.rises[i] != rises || way > part) continue;
                if (pass == 0) {
                    n += 1;
                    mean += u;
                } else {
                    squares += std::pow(u - mean / n, 2);
                }
            }
        variance += std::pow(.5, 2) / squares / 4;
    }
    EXPECT_NEAR(weighted_error(*initial_stiffness(rows, part), rows), std::sqrt(variance),
                1e-9 * std::sqrt(variance));
}

}  // namespace tricontact::experiments::loop_stiffness_test
