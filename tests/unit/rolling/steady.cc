#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/relaxing_case.h"
#include "contact/substrates/substrate.h"
#include "rolling/linear_creep.h"
#include "rolling/run.h"
#include "tests/unit/rolling/kalker_force.h"
#include "tests/unit/rolling/problems.h"
#include "theory/layer/layer_stack.h"
#include "theory/rolling/kalker.h"

namespace tricontact::steady_test {
namespace {

using rolling::RollingProblem;
using rolling::RollingState;
using rolling_test::Rig;

/// Creepage over mu a/R, force over mu F_N, moment over mu F_N a, dissipation over mu^2 F_N a/R.
std::vector<double> numbers_of(const RollingState& s, const Rig& rig) {
    const double limit = rig.friction * s.normal_force;
    return {s.creepage.longitudinal / rig.creepage(),
            s.creepage.lateral / rig.creepage(),
            s.force[0] / limit,
            s.force[1] / limit,
            s.spin_moment / (limit * rig.half_length),
            s.dissipation / (limit * rig.creepage())};
}

/// Transient rolling over `distance` ends where the steady state is found directly.
void expect_transient_ends_there(const Rig& rig, std::shared_ptr<const contact::Compliance> grid,
                                 const RollingProblem& problem, double distance, double allowed) {
    const contact::ElasticSubstrate substrate(std::move(grid));
    const auto direct = rolling::steady_rolling(substrate, problem);
    const auto steady = numbers_of(direct.state, rig);
    const auto last =
        numbers_of(rolling_test::rolled_from_rest(substrate, problem, distance).back(), rig);
    for (std::size_t i = 0; i < steady.size(); ++i) EXPECT_NEAR(last[i], steady[i], allowed) << i;
    EXPECT_TRUE(direct.audit.passed());
    for (const auto& check : direct.audit.checks())
        EXPECT_LE(check.worst, check.allowed) << check.name;
}

// What rolling on still changes falls by ten in about three half lengths.
TEST(SteadyRolling, IsWhereTransientRollingEnds) {
    const Rig rig{.n = 6};
    expect_transient_ends_there(rig, rig.sphere_grid(), rig.sphere(.6), 16 * rig.half_length, 1e-6);
    RollingProblem spinning = rig.sphere(.3);
    spinning.drive.spin = .8 * rig.friction / rig.radius;
    expect_transient_ends_there(rig, rig.sphere_grid(), spinning, 16 * rig.half_length, 1e-6);
    RollingProblem creeping = rig.sphere(0);
    creeping.drive.creepage = {.3 * rig.creepage(), -.5 * rig.creepage()};
    expect_transient_ends_there(rig, rig.sphere_grid(), creeping, 24 * rig.half_length, 1e-5);
}

TEST(SteadyRolling, IsWhereTransientRollingEndsOfCoupledBodies) {
    const Rig rig{.substrate = {3e6, .2}, .n = 5};
    RollingProblem problem = rig.sphere(.4);
    problem.tolerance = 1e-7;
    expect_transient_ends_there(rig, rig.sphere_grid(), problem, 14 * rig.half_length, 1e-5);
}

TEST(SteadyRolling, IsWhereTransientRollingEndsOnALayer) {
    const Rig rig{.n = 5};
    contact::Case layered;
    layered.substrate = {3e6, .4};
    layered.layer.thickness = 1.3 * rig.half_length;
    const int beside = 9;
    const contact::Vector2 first = {-beside * rig.cell(), -beside * rig.cell()};
    const std::shared_ptr<const contact::Compliance> grid =
        bem::layer_compliance(theory::layers_of("bem-layer", layered), std::nullopt,
                              contact::ContactPoints::grid(2 * beside + 1, 2 * beside + 1, first,
                                                           {rig.cell(), rig.cell()}),
                              1);
    RollingProblem problem = rig.sphere(.4);
    problem.tolerance = 1e-7;
    problem.drive.spin = .3 * rig.friction / rig.radius;
    expect_transient_ends_there(rig, grid, problem, 14 * rig.half_length, 1e-5);
}

// Kalker's C23: to the left when turning to the left, and nothing along the way.
TEST(SteadyRolling, FrictionGivesNoEnergyBackAtAnyPoint) {
    const Rig rig{.n = 8};
    const auto steady = rolling::steady_rolling(*rig.sphere_grid(), rig.sphere(.6));
    for (std::size_t i = 0; i < steady.surface.size(); ++i) {
        const bool slips = steady.surface.contact_state[i] == contact::ContactState::slip;
        EXPECT_EQ(steady.surface.dissipation[i] > 0, slips);
        EXPECT_GE(steady.surface.dissipation[i], 0);
        EXPECT_EQ(steady.surface.slip_x[i] != 0, slips);
    }
}

TEST(SteadyRolling, SpinAlonePushesSideways) {
    const Rig rig{.n = 15};
    RollingProblem problem = rig.sphere(0);
    problem.drive.creepage = {0, 0};
    problem.drive.spin = .02 * rig.friction / rig.radius;
    const auto state = rolling::steady_rolling(*rig.sphere_grid(), problem).state;
    const auto linear =
        rolling_test::kalker_force(theory::combined_material(rig.materials()), rig.half_length,
                                   rig.half_length, {.spin = problem.drive.spin});
    // A thirtieth of the contact's width to a cell, and slip at its trailing edge: some percent.
    EXPECT_NEAR(state.force[1] / linear.lateral, 1, .08);
    EXPECT_NEAR(state.force[0] / linear.lateral, 0, 1e-6);
}

/// A strip of 2 n cells that sticks, moved over the substrate by slip along y: force per slip that
/// grows along x, and moment per constant slip, both over the exact ones.
std::array<double, 2> spin_of_strip(int n) {
    const Rig rig{.n = n};
    constexpr int beside = 3;
    const double length = 1e4 * rig.half_length;  // whose ends are out of sight of 1e-7
    auto grid = contact::ContactPoints::grid(
        2 * (n + beside), 1, {(.5 - n - beside) * rig.cell(), 0}, {rig.cell(), length});
    grid.line_length = length;
    const auto strip = bem::half_space_compliance(rig.materials(), std::move(grid), 1);
    std::vector<double> pressure(strip->points().size());
    std::fill_n(pressure.begin() + beside, 2 * n, 1);
    const auto creep = rolling::linear_creep(*strip, pressure);
    // du/dx = -1/(pi G) int t/(x - s) ds is minus the slip. Slip 1: t = G ((a - x)/(a + x))^(1/2),
    // of the moment -pi G a^2/2; by reciprocity that is minus the force of the slip x.
    const double exact = std::numbers::pi / 2 * rig.substrate.shear_modulus() * rig.half_length *
                         rig.half_length * length;
    return {creep[1][2] / exact, -creep[2][1] / exact};
}

// The slip of a step by spin is that at contact::spin_point: else the error were of the first
// order, its part 2 (1/4 - delta) h/a, 1.7 % at 20 cells.
TEST(SteadyRolling, SpinOfAStripIsOfTheSecondOrder) {
    const std::array sizes = {10, 21, 40};
    std::vector<double> error;
    for (const int n : sizes) {
        const auto [force, moment] = spin_of_strip(n);
        error.push_back(std::abs(force - 1));
        EXPECT_NEAR(moment / force, 1, 1e-6) << n;  // reciprocity
    }
    for (std::size_t k = 1; k < error.size(); ++k)
        EXPECT_NEAR(std::log(error[k - 1] / error[k]) / std::log(1. * sizes[k] / sizes[k - 1]), 2,
                    .2)
            << sizes[k];
    EXPECT_LT(error[2], 1e-4);
}

// Its definition: 1/4 less the edge that constant tractions add to line loads
// (contact/substrates/substrate.h).
TEST(SteadyRolling, SpinPointFollowsFromTheSymbolOfTheCells) {
    using std::numbers::pi;
    const auto log_rho = [](double q) {
        double sum = 1 / (q * q);
        // Pairs of m fall like m^-3 and change their sign: the rest is below half of the next one.
        for (int m = 1; m <= 1000; ++m)
            sum += (m % 2 ? -1 : 1) * (std::pow(q + 2 * pi * m, -2) - std::pow(q - 2 * pi * m, -2));
        return std::log(4 * std::pow(std::sin(q / 2), 2) * sum);
    };
    double delta = 0;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i) {
        const double q = (i + .5) * pi / n;
        delta -= log_rho(q) / (4 * std::pow(std::sin(q / 2), 2)) / n;
    }
    EXPECT_NEAR(1. / 4 - delta, contact::spin_point, 1e-6);
}

/// Half cells across: steady states of unequal spacings.
std::shared_ptr<const contact::Compliance> unequal_grid(const Rig& rig) {
    const int beside_x = rig.n + 3, beside_y = 2 * rig.n + 3;
    return bem::half_space_compliance(
        rig.materials(),
        contact::ContactPoints::grid(2 * beside_x + 1, 2 * beside_y + 1,
                                     {-beside_x * rig.cell(), -beside_y * rig.cell() / 2},
                                     {rig.cell(), rig.cell() / 2}),
        1);
}

TEST(SteadyRolling, OnUnequalSpacingsIsWhereTransientRollingEnds) {
    const Rig rig{.n = 5};
    RollingProblem problem = rig.sphere(.5);
    problem.drive.spin = .6 * rig.friction / rig.radius;
    expect_transient_ends_there(rig, unequal_grid(rig), problem, 14 * rig.half_length, 1e-5);
}

// Of little creepage and spin Kalker's linear theory, whatever the sides of the cells; lengths by
// the area that the cells cover. Slip at the trailing edge and its steps leave some percent.
TEST(SteadyRolling, OnUnequalSpacingsIsKalkers) {
    const Rig rig{.n = 12};
    const double small = .02 * rig.creepage();
    const auto linear = [&](const RollingState& s, const rolling::Creepage& creepage) {
        const double a = std::sqrt(s.contact_area / std::numbers::pi);
        return rolling_test::kalker_force(theory::combined_material(rig.materials()), a, a,
                                          creepage);
    };
    RollingProblem problem = rig.sphere(0);
    problem.drive.creepage = {small, 0};
    const auto along = rolling::steady_rolling(*unequal_grid(rig), problem).state;
    EXPECT_NEAR(along.force[0] / linear(along, {.longitudinal = small}).longitudinal, 1, .05);
    problem.drive.creepage = {0, 0};
    problem.drive.spin = small / rig.half_length;
    const auto turned = rolling::steady_rolling(*unequal_grid(rig), problem).state;
    EXPECT_NEAR(turned.force[1] / linear(turned, {.spin = problem.drive.spin}).lateral, 1, .05);
    EXPECT_NEAR(turned.half_length, turned.half_width, 1.5 * rig.cell());
    EXPECT_NEAR(turned.contact_area / (std::numbers::pi * rig.half_length * rig.half_length), 1,
                .04);
}

// Carter (1926); Johnson (1985), eq. 8.26: one cell's step is first order, 3 % at 20 cells.
TEST(SteadyRolling, OfACylinderCreepsAsCarterSays) {
    const Rig rig;
    const double f = .6;
    const auto steady = rolling::steady_rolling(*rig.row_grid(), rig.row(f));
    const double carter = rig.creepage() * (1 - std::sqrt(1 - f));
    EXPECT_NEAR(steady.state.creepage.longitudinal, carter, .03 * carter);
    EXPECT_NEAR(steady.state.half_length, rig.half_length, rig.cell());
    EXPECT_NEAR(steady.state.stick_area / steady.state.contact_area, std::sqrt(1 - f), .05);
    // Stick begins at the leading edge, but for the cell that the edge cuts.
    const auto& states = steady.surface.contact_state;
    const auto first = std::find(states.begin(), states.end(), contact::ContactState::stick);
    const auto open = std::find(first, states.end(), contact::ContactState::open);
    EXPECT_LE(std::count(first, open, contact::ContactState::slip), 1);
    EXPECT_GT(std::count(states.begin(), first, contact::ContactState::slip), 0);
}

// Friction at its limit everywhere, along the creepage: F = mu F_N.
TEST(SteadyRolling, SaturatesAtLargeCreepage) {
    const Rig rig{.n = 8};
    RollingProblem problem = rig.sphere(0);
    problem.drive.creepage = {30 * rig.creepage(), 40 * rig.creepage()};
    const auto state = rolling::steady_rolling(*rig.sphere_grid(), problem).state;
    const double limit = rig.friction * rig.sphere_force();
    // What elasticity turns of the slip is a fiftieth of it, the force lost its square.
    EXPECT_NEAR(state.force[0] / limit, .6, 2e-3);
    EXPECT_NEAR(state.force[1] / limit, .8, 2e-3);
    EXPECT_EQ(state.stick_area, 0);
}

// Where the pressure of dissimilar bodies alone makes nearly all slip, or the force is nearly what
// friction carries, creepage has far to go.
TEST(SteadyRolling, ConvergesWhereNearlyAllSlips) {
    Rig rig{.n = 6};
    rig.substrate.poisson = 0;
    rig.friction = .05;
    RollingProblem problem = rig.sphere(.4);
    problem.tolerance = 1e-7;
    EXPECT_TRUE(rolling::steady_rolling(*rig.sphere_grid(), problem).audit.passed());
    rig.substrate.poisson = .5;
    // So little friction that no cell sticks at nearly all creepages.
    rig.substrate.poisson = .3;
    rig.friction = 1e-3;
    problem = rig.row(.56);
    problem.tolerance = 1e-7;
    EXPECT_TRUE(rolling::steady_rolling(*rig.row_grid(), problem).audit.passed());
    rig.substrate.poisson = 0;
    rig.friction = .01;
    problem = rig.sphere(.56);
    problem.tolerance = 1e-7;
    EXPECT_TRUE(rolling::steady_rolling(*rig.sphere_grid(), problem).audit.passed());
    rig.friction = .05;
    rig.substrate.poisson = .5;
    problem = rig.sphere(.998);
    problem.drive.spin = 9 * rig.friction / rig.radius;
    EXPECT_TRUE(rolling::steady_rolling(*rig.sphere_grid(), problem).audit.passed());
}

// Friction at its limit against a turn about the centre: mu int p r dA = 3 pi/16 mu F_N a, and no
// force but what the point of the slip leaves, some 1/200 of mu F_N by 1/50 of a.
TEST(SteadyRolling, TurningOnTheSpotTakesTheMomentOfAllFriction) {
    const Rig rig{.n = 10};
    RollingProblem problem = rig.sphere(0);
    problem.drive.creepage = {0, 0};
    problem.drive.spin = 200 * rig.friction / rig.radius;
    const auto state = rolling::steady_rolling(*rig.sphere_grid(), problem).state;
    const double limit = rig.friction * rig.sphere_force();
    EXPECT_NEAR(state.spin_moment / (limit * rig.half_length), 3 * std::numbers::pi / 16, .01);
    EXPECT_NEAR(state.force[0] / limit, 0, 1e-3);
}

// Rolling on for as long again changes no more than roll_until_steady promises, 1e-5 of each of
// the units, here over F_N and a.
TEST(SteadyRolling, OfARelaxingSubstrateIsWhereRollingOnStays) {
    constexpr int behind = 8, ahead = 40;
    const Rig rig{.n = 6};
    auto grid = contact::ContactPoints::grid(behind + ahead + 1, 1, {-behind * rig.cell(), 0},
                                             {rig.cell(), rig.row_length()});
    grid.line_length = rig.row_length();
    const contact::RelaxingSubstrate substrate(
        bem::half_space_compliance(rig.materials(), std::move(grid), 1), {{{2, .3}}});
    RollingProblem problem = rig.row(0);
    problem.drive.creepage = {.3 * rig.creepage(), 0};
    problem.speed = rig.half_length / .3;
    problem.tolerance = 1e-7;
    rolling::TransientRolling rolling(substrate, problem);
    const auto steady = rolling::roll_until_steady(rolling, {rolling.press()}).state;
    RollingState later = steady;
    for (int step = 0; step < 300; ++step) later = rolling.roll();
    const double limit = rig.friction * steady.normal_force;
    EXPECT_NEAR(later.force[0] / limit, steady.force[0] / limit, 2e-5);
    EXPECT_NEAR(later.indentation / steady.indentation, 1, 2e-5);
    EXPECT_NEAR(later.pressure_lead / rig.half_length, steady.pressure_lead / rig.half_length,
                2e-5);
    EXPECT_GT(steady.pressure_lead, .01 * rig.half_length);
    // What resists is the pressure on the slope x/R.
    EXPECT_NEAR(steady.resistance / (steady.normal_force * steady.pressure_lead / rig.radius), 1,
                1e-9);
}

// Mirror the contact at the plane of rolling: lateral creepage, force and spin change their signs.
TEST(SteadyRolling, IsSymmetricToThePlaneOfRolling) {
    const Rig rig{.n = 8};
    RollingProblem problem = rig.sphere(0);
    problem.drive.creepage = {.4 * rig.creepage(), .3 * rig.creepage()};
    problem.drive.spin = .7 * rig.friction / rig.radius;
    const auto one = rolling::steady_rolling(*rig.sphere_grid(), problem).state;
    *problem.drive.creepage[1] *= -1;
    problem.drive.spin *= -1;
    const auto other = rolling::steady_rolling(*rig.sphere_grid(), problem).state;
    const double limit = rig.friction * rig.sphere_force();
    EXPECT_NEAR(one.force[0] / limit, other.force[0] / limit, 1e-7);
    EXPECT_NEAR(one.force[1] / limit, -other.force[1] / limit, 1e-7);
    EXPECT_NEAR(one.spin_moment / (limit * rig.half_length),
                -other.spin_moment / (limit * rig.half_length), 1e-7);
    EXPECT_GT(std::abs(one.force[1]), .1 * limit);
}

TEST(SteadyRolling, RefusesAForceThatFrictionDoesNotCarry) {
    const Rig rig{.n = 4};
    try {
        rolling::steady_rolling(*rig.sphere_grid(), rig.sphere(1.01));
        FAIL() << "no error";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("reaches the friction limit"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace tricontact::steady_test
