#include "experiments/records/settling_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/run.h"
#include "contact/verdict.h"
#include "experiments/records/experiment_run.h"
#include "mdr/model.h"

namespace tricontact::experiments::settling_fit_test {
namespace {

using contact::State;

constexpr int n_sets = 200;
// Of a part of n that should be p: three standard deviations of the binomial.
double scatter(double p, int n = n_sets) {
    return 3 * std::sqrt(p * (1 - p) / n);
}

std::vector<double> shift_of(double transient, double q, double increment, double noise,
                             int periods, std::mt19937_64& random) {
    std::normal_distribution<double> gauss;
    std::vector<double> shift;
    for (int n = 0; n <= periods; ++n)
        shift.push_back(100 - transient * std::pow(q, n) + increment * n + noise * gauss(random));
    return shift;
}

std::vector<double> counts(std::size_t n) {
    std::vector<double> t;
    for (std::size_t i = 0; i < n; ++i) t.push_back(static_cast<double>(i));
    return t;
}

TEST(SettlingFitSlow, IntervalsCoverTheTruthAsOftenAsTheyClaim) {
    std::mt19937_64 random(1);
    for (const double confidence : {0.683, 0.95})
        for (const double increment : {0., 1.}) {
            int n_increment = 0, n_settled = 0;
            for (int i = 0; i < n_sets; ++i) {
                const auto fit =
                    fit_settling(shift_of(40, 0.5, increment, 0.05, 12, random), confidence);
                n_increment += fit.increment.low <= increment && increment <= fit.increment.high;
                n_settled += fit.settled.low <= 100 && 100 <= fit.settled.high;
            }
            EXPECT_NEAR(n_increment / double(n_sets), confidence, scatter(confidence));
            if (increment > 0) continue;
            // Where the transient has died out q is unknown and the profile over it conservative.
            EXPECT_GT(n_settled / double(n_sets), confidence - scatter(confidence));
        }
}

TEST(SettlingFit, WithoutNoiseItIsExact) {
    std::mt19937_64 random(1);
    const auto fit = fit_settling(shift_of(40, 0.5, 3, 0, 8, random), 0.95);
    EXPECT_NEAR(fit.increment.value, 3, 1e-10);
    EXPECT_NEAR(fit.ratio, 0.5, 1e-15);
    EXPECT_NEAR(fit_settling(shift_of(40, 0.7, 0, 0, 8, random), 0.95).settled.value, 100, 1e-10);
    EXPECT_THROW(fit_settling({1, 2, 3, 4, 5}, 0.95), std::invalid_argument);
}

TEST(SettlingFit, SlowTransientsAreNotTakenForAWalk) {
    // Five periods of a transient that has lost a fifth: neither can be excluded.
    std::mt19937_64 random(2);
    const auto fit = fit_settling(shift_of(40, 0.95, 0, 0.5, 5, random), 0.95);
    EXPECT_EQ(judge_increment(fit.increment, 5, 100), State::undecided);
}

TEST(Curvature, IsThatOfTheParabola) {
    const std::vector<double> t{2, 3, 4, 5, 6, 7};
    std::vector<double> u;
    for (const double x : t) u.push_back(5 + 3 * (x - 2) - 0.4 * (x - 2) * (x - 2));
    // u(2) = 5 and u(7) = 10: over the rise 5 and the duration 5, 2 (-0.4) 5^2/5 = -4.
    EXPECT_NEAR(normalised_curvature(t, u, 0.95).value, -4, 1e-10);
    EXPECT_TRUE(std::isnan(normalised_curvature(t, {1, 2, 3, 3, 2, 1}, 0.95).value));
}

// Steady ratcheting has no curvature: its sign is that of the noise, its interval contains 0 as
// often as it should.
TEST(Curvature, OfASteadyWalkHasEitherSign) {
    std::mt19937_64 random(3);
    constexpr int n_straight = 10 * n_sets;  // quickly done
    int n_negative = 0, n_undecided = 0;
    for (int i = 0; i < n_straight; ++i) {
        const auto u = shift_of(0, 0.5, 1, 0.05, 12, random);
        const auto curvature = normalised_curvature(counts(u.size()), u, 0.95);
        n_negative += curvature.value < 0;
        n_undecided += contact::state_of(curvature.low, curvature.high, 0) == State::undecided;
    }
    EXPECT_NEAR(n_negative / double(n_straight), 0.5, scatter(0.5, n_straight));
    EXPECT_NEAR(n_undecided / double(n_straight), 0.95, scatter(0.95, n_straight));
}

// Verdicts on synthetic shifts: by the increment at most 2.5 % (one side of 95 %) of settled
// contacts are said to ratchet.
TEST(RatchetingVerdict, ByTheIncrementErrsAsSeldomAsStated) {
    std::mt19937_64 random(4);
    int n_false_ratcheting = 0, n_ratcheting = 0;
    for (int i = 0; i < n_sets; ++i) {
        const auto settled = fit_settling(shift_of(40, 0.5, 0, 2, 12, random), 0.95);
        n_false_ratcheting += judge_increment(settled.increment, 12, 100) == State::ratcheting;
        const auto ratcheting = fit_settling(shift_of(40, 0.5, 2, 0.5, 12, random), 0.95);
        n_ratcheting += judge_increment(ratcheting.increment, 12, 124) == State::ratcheting;
    }
    EXPECT_LT(n_false_ratcheting / double(n_sets), 0.025 + scatter(0.025));
    EXPECT_EQ(n_ratcheting, n_sets);
}

// The sphere of the thesis' first rig on MDR's springs, at the ratios of its figures.
std::vector<double> history(double w, double f, State expected) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = f;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->run_all = true;
    c.rolling->steps = contact::Case::Steps::turning_points;
    const auto model = mdr::make_model(c);
    const auto run = contact::run(c, *model);
    EXPECT_EQ(run.verdict.state, expected) << w << ' ' << f;
    std::vector<double> shift{run.static_shift};
    shift.insert(shift.end(), run.shift_per_period.begin(), run.shift_per_period.end());
    return shift;
}

// MDR's limit is 1 - 1.5 w + 0.5 w^3: 0.647 at w = 0.24. Just beyond it the shift rises fast at
// first and then steadily: its parabola bends like that of a contact that settles.
TEST(RatchetingVerdict, ByTheIncrementAgreesWithMdrAndTheCurvatureDoesNot) {
    for (const double f : {0.3, 0.56, 0.63}) {
        const auto u = history(0.24, f, State::shakedown);
        EXPECT_EQ(judge_increment(fit_settling(u, 0.95).increment, 12, u.back()), State::shakedown);
        EXPECT_LT(normalised_curvature(counts(u.size()), u, 0.95).value, 0);
    }
    for (const double f : {0.665, 0.7, 0.8}) {
        const auto u = history(0.24, f, State::ratcheting);
        EXPECT_EQ(judge_increment(fit_settling(u, 0.95).increment, 12, u.back()),
                  State::ratcheting);
    }
    const auto near = history(0.24, 0.665, State::ratcheting);
    const auto curvature = normalised_curvature(counts(near.size()), near, 0.95);
    EXPECT_EQ(contact::state_of(curvature.low, curvature.high, 0), State::shakedown);
}

}  // namespace
}  // namespace tricontact::experiments::settling_fit_test
