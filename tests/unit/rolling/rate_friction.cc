// Steady rolling under friction that falls with the speed of slip. Beside CONTACT: see
// tests/verification/rolling/contact_program.cc.

#include "rolling/rate_friction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rolling/rolling_report.h"
#include "tests/unit/rolling/problems.h"

namespace tricontact::rate_friction_test {
namespace {

using contact::FrictionRate;
using Law = FrictionRate::Law;
using rolling::RollingProblem;
using rolling::SlipStart;
using rolling_test::Rig;

const Rig rig{.n = 40};
constexpr double speed = 3;  // [m/s]

/// Half of `drop` is lost at this share of the slip of a creepage mu a/R.
FrictionRate falling(double share, double drop = .1, Law law = Law::exponential) {
    return {law, {drop}, {share * speed * rig.creepage()}};
}

RollingProblem row(double creepage, const FrictionRate& rate) {
    RollingProblem problem = rig.row(0);
    problem.drive.creepage[0] = creepage * rig.creepage();
    problem.speed = speed;
    problem.rate = rate;
    return problem;
}

const rolling_test::SteadyRow steady(rig);

double force(const RollingProblem& problem) {
    return steady.force(problem);
}

RollingProblem coulomb(double creepage, double mu) {
    RollingProblem problem = row(creepage, {});
    problem.friction = contact::Friction{mu}.law();
    problem.rate.reset();
    return problem;
}

// So slow that nothing is lost, and so fast that all that slips has lost all: Coulomb's law, with
// the smaller coefficient where the search comes from fast slip.
TEST(RateFriction, EndsAreCoulombs) {
    const double drop = .1, creepage = .6;
    EXPECT_NEAR(force(row(creepage, falling(1e9, drop))), force(coulomb(creepage, rig.friction)),
                1e-7);
    RollingProblem fast = row(creepage, falling(1e-9, drop));
    fast.slip_start = SlipStart::fast;
    EXPECT_NEAR(force(fast), force(coulomb(creepage, rig.friction - drop)), 1e-7);
    // From slow slip the same law has a state with more stick: what sticks carries mu at rest.
    fast.slip_start = SlipStart::slow;
    EXPECT_GT(force(fast), force(coulomb(creepage, rig.friction - drop)) + .001);
}

// Each point that slips carries what its own slip leaves of mu, each that sticks at most mu at
// rest.
TEST(RateFriction, EachPointFollowsItsSlip) {
    for (const Law law : {Law::linear, Law::rational, Law::exponential}) {
        const RollingProblem problem = row(.8, falling(1, .1, law));
        const auto found = steady(problem);
        const auto& s = found.surface;
        int slips = 0;
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double v = speed * std::abs(s.slip_x[i]), p = s.normal_traction[i];
            const double mu = problem.rate->coefficient(rig.friction, v);
            if (s.contact_state[i] == contact::ContactState::slip) {
                EXPECT_NEAR(s.tangential_traction_x[i] / (mu * p), 1, 1e-6);
                ++slips;
            }
            EXPECT_LE(std::abs(s.tangential_traction_x[i]), mu * p * (1 + 1e-6) + 1e-6);
        }
        EXPECT_GT(slips, 20);
    }
}

// Where all slips much faster than it is strained, mu is that of the creepage; and the force falls
// with it.
TEST(RateFriction, SlidesAsFastAsItCreeps) {
    double before = 1;
    for (const double creepage : {100., 200., 400.}) {
        const RollingProblem problem = row(creepage, falling(100));
        const double mu =
            problem.rate->coefficient(rig.friction, speed * creepage * rig.creepage());
        // Strains of mu a/R are a hundredth of the slip here.
        EXPECT_NEAR(force(problem), mu / rig.friction, .01 * (1 - mu / rig.friction));
        EXPECT_LT(force(problem), before);
        before = force(problem);
    }
}

// Dissipation is the work of the creepage, of first order in the cell as under Coulomb's law.
TEST(RateFriction, EnergyIsBalanced) {
    const auto error = [](const RollingProblem& problem) {
        return rolling::energy_error(steady(problem).state).value();
    };
    EXPECT_LT(error(row(.6, falling(1))), 2 * error(coulomb(.6, rig.friction)) + 1e-6);
}

// From slow and from fast slip the same state, where friction falls so little that there is one.
TEST(RateFriction, BothWaysMeetWhereFrictionFallsSlowly) {
    RollingProblem problem = row(.8, falling(3, .05));
    const double slow = force(problem);
    problem.slip_start = SlipStart::fast;
    EXPECT_NEAR(force(problem), slow, 1e-6);
}

// A search that knows the state of the other one costs less where both meet, and leads to its own
// end where they do not: Coulomb's law with what friction has left.
TEST(RateFriction, KnowsTheStateOfTheOtherSearch) {
    for (const bool meet : {true, false}) {
        const double drop = meet ? .05 : .1, creepage = meet ? .8 : .6;
        RollingProblem problem = row(creepage, falling(meet ? 3 : 1e-9, drop));
        const auto slow = steady(problem);
        problem.slip_start = SlipStart::fast;
        const auto alone = steady(problem);
        problem.other_state = &slow.surface;
        const auto knowing = steady(problem);
        EXPECT_NEAR(knowing.state.force[0] / alone.state.force[0], 1, 1e-6);
        if (meet) {
            EXPECT_LT(knowing.state.iterations, .7 * alone.state.iterations);
            EXPECT_NEAR(knowing.state.force[0] / slow.state.force[0], 1, 1e-6);
        } else {
            EXPECT_LT(knowing.state.force[0], slow.state.force[0] * (1 - 1e-3));
        }
    }
}

// A long memory keeps mu at rest, a short one none.
TEST(RateFriction, MemoryLiesBetween) {
    RollingProblem problem = row(.8, falling(1));
    const double none = force(problem), rest = force(coulomb(.8, rig.friction));
    double before = none;
    for (const double share : {1e-3, .1, 1., 1e3}) {
        problem.rate->memory_length = share * rig.half_length * rig.creepage();
        const double now = force(problem);
        EXPECT_GT(now, before - 1e-9);
        before = now;
    }
    EXPECT_NEAR(before, rest, 2e-3);
    EXPECT_GT(rest, none + .01);
}

// A force that friction at rest carries and falling friction does not.
TEST(RateFriction, ForceBeyondWhatSlips) {
    RollingProblem problem = rig.row(.9);
    problem.speed = speed;
    problem.rate = falling(.1, .2);
    EXPECT_THROW(steady(problem), contact::InputError);
    problem.drive.force[0] /= 2;
    EXPECT_NEAR(steady(problem).state.force[0] / problem.drive.force[0], 1, 1e-9);
}

// Unlike bodies, whose tractions displace each other: the staggered iteration keeps its state of
// friction.
TEST(RateFriction, OfCoupledBodies) {
    const Rig unlike{.friction = .2, .substrate = {3e6, .1}, .n = 20};
    RollingProblem problem = unlike.row(0);
    problem.drive.creepage[0] = .7 * unlike.creepage();
    problem.speed = speed;
    problem.rate = FrictionRate{Law::exponential, {.08}, {speed * unlike.creepage()}};
    const auto grid = unlike.row_grid();
    ASSERT_TRUE(grid->is_coupled());
    const auto slow = rolling::steady_rolling(*grid, problem);
    problem.slip_start = SlipStart::fast;
    const auto fast = rolling::steady_rolling(*grid, problem);
    for (const auto& found : {slow, fast}) {
        EXPECT_TRUE(found.audit.passed());
        const auto& s = found.surface;
        for (std::size_t i = 0; i < s.size(); ++i) {
            if (s.contact_state[i] != contact::ContactState::slip) continue;
            const double mu =
                problem.rate->coefficient(unlike.friction, speed * std::abs(s.slip_x[i]));
            EXPECT_NEAR(std::abs(s.tangential_traction_x[i]) / (mu * s.normal_traction[i]), 1,
                        1e-6);
        }
    }
    EXPECT_NEAR(fast.state.force[0] / slow.state.force[0], 1, 1e-6);
}

/// The plain iteration: the steady state under given bounds, mu of its slip, and so on. Here half a
/// dozen digits remain of each.
std::vector<double> plainly_iterated(const contact::Compliance& grid, const RollingProblem& problem,
                                     double mu, const std::vector<double>& pressure, double start) {
    const auto law = rolling::friction_by_rate(grid.points(), *problem.rate, mu, problem.speed);
    const contact::TangentialField none(pressure.size());
    std::vector<double> left(pressure.size(), start), bound(pressure.size());
    rolling::SteadySolution solution;
    for (int k = 0; k < 60; ++k) {
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = left[i] * mu * pressure[i];
        rolling::solve_steady(grid, {bound, none, problem.drive}, {1e-8}, solution);
        left = law.left(solution);
    }
    return solution.traction.x;
}

// Newton's method comes last: the states are those of the plain iteration from both ends, with and
// without a memory, for up to 1.5 times the products of Coulomb's law.
TEST(RateFriction, IsThePlainIterationForLess) {
    Rig ball{.n = 10};
    const auto grid = ball.sphere_grid();
    RollingProblem problem = ball.sphere(0);
    problem.drive.creepage = {.5 * ball.creepage(), .4 * ball.creepage()};
    problem.speed = speed;
    const int coulombs = rolling::steady_rolling(*grid, problem).state.iterations;
    problem.rate = FrictionRate{Law::exponential, {.12}, {.5 * speed * ball.creepage()}};
    for (const double memory : {0., .3}) {
        problem.rate->memory_length = memory * ball.half_length * ball.creepage();
        for (const SlipStart start : {SlipStart::slow, SlipStart::fast}) {
            problem.slip_start = start;
            const auto found = rolling::steady_rolling(*grid, problem);
            EXPECT_TRUE(found.audit.passed());
            EXPECT_LT(found.state.iterations, 2 * coulombs);
            const auto plain =
                plainly_iterated(*grid, problem, ball.friction, found.surface.normal_traction,
                                 start == SlipStart::slow ? 1 : 1 - .12 / ball.friction);
            double most = 0;
            for (const double t : plain) most = std::max(most, std::abs(t));
            for (std::size_t i = 0; i < plain.size(); ++i)
                EXPECT_NEAR(found.surface.tangential_traction_x[i] / most, plain[i] / most, 1e-6);
        }
    }
}

// On a sphere, along both axes: friction falls with the magnitude of slip.
TEST(RateFriction, Sphere) {
    Rig ball{.n = 10};
    RollingProblem problem = ball.sphere(0);
    problem.drive.creepage = {.5 * ball.creepage(), .4 * ball.creepage()};
    problem.drive.spin = 2;
    problem.speed = speed;
    problem.rate = FrictionRate{Law::rational, {.05, .05}, {.004, .008}};
    const auto found = rolling::steady_rolling(*ball.sphere_grid(), problem);
    EXPECT_TRUE(found.audit.passed());
    const auto& s = found.surface;
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (s.contact_state[i] != contact::ContactState::slip) continue;
        const double mu =
            problem.rate->coefficient(ball.friction, speed * std::hypot(s.slip_x[i], s.slip_y[i]));
        EXPECT_NEAR(std::hypot(s.tangential_traction_x[i], s.tangential_traction_y[i]) /
                        (mu * s.normal_traction[i]),
                    1, 1e-6);
    }
}

}  // namespace
}  // namespace tricontact::rate_friction_test
