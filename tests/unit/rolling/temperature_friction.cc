// Steady rolling under friction that changes with the temperature of the surfaces. Beside CONTACT:
// see tests/verification/rolling/contact_program.cc.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/substrates/substrate.h"
#include "rolling/temperatures.h"
#include "tests/unit/rolling/problems.h"

namespace tricontact::temperature_friction_test {
namespace {

using contact::FrictionTemperature;
using rolling::RollingProblem;
using rolling::SlipStart;
using rolling_test::Rig;

const Rig rig{.n = 40};
constexpr double speed = 7;  // [m/s]
const contact::ContactHeat heat{{50, 450, 7850, 20}, {.9, 800, 2500, 20}};

RollingProblem row(double creepage, std::optional<FrictionTemperature> law) {
    RollingProblem problem = rig.row(0);
    problem.drive.creepage[0] = creepage * rig.creepage();
    problem.speed = speed;
    problem.heat = heat;
    problem.friction_temperature = law;
    return problem;
}

const rolling_test::SteadyRow steady(rig);

double force(const RollingProblem& problem) {
    return steady.force(problem);
}

/// Of a constant mu.
double coulomb(double creepage, double mu) {
    RollingProblem problem = row(creepage, {});
    problem.friction = contact::Friction{mu}.law();
    return force(problem);
}

/// Half of the change is there where so much of the heating of sliding at mu is.
FrictionTemperature half_at(double share, double creepage, double change) {
    const double rise = steady(row(creepage, {})).state.temperature->friction_rise;
    return {change, 20, 20 + 2 * share * rise};
}

// What changes far above all temperatures is not felt; what has changed below the bulk's is
// another coefficient.
TEST(TemperatureFriction, EndsAreCoulombs) {
    EXPECT_NEAR(force(row(.6, FrictionTemperature{-.1, 1e7, 2e7})), coulomb(.6, rig.friction),
                1e-7);
    EXPECT_NEAR(force(row(.6, FrictionTemperature{-.1, -60, 10})), coulomb(.6, rig.friction - .1),
                1e-7);
    EXPECT_NEAR(force(row(.6, FrictionTemperature{.1, -60, 10})), coulomb(.6, rig.friction + .1),
                1e-7);
}

// Each point that slips carries what its own temperature leaves of mu, in partial slip, too; from
// cold and from hot surfaces it is the same state.
TEST(TemperatureFriction, EachPointFollowsItsTemperature) {
    for (const double change : {-.15, .15})
        for (const double creepage : {.8, 30.}) {
            RollingProblem problem = row(creepage, half_at(.4, creepage, change));
            const auto found = steady(problem);
            const auto& s = found.surface;
            int slips = 0;
            for (std::size_t i = 0; i < s.size(); ++i) {
                const double mu = problem.friction_temperature->coefficient(
                    rig.friction, found.temperatures->substrate[i]);
                EXPECT_LE(std::abs(s.tangential_traction_x[i]),
                          mu * s.normal_traction[i] * (1 + 1e-6) + 1e-6);
                if (s.contact_state[i] != contact::ContactState::slip) continue;
                EXPECT_NEAR(s.tangential_traction_x[i] / (mu * s.normal_traction[i]), 1, 1e-6);
                ++slips;
            }
            EXPECT_GT(slips, 20);
            problem.slip_start = SlipStart::fast;
            EXPECT_NEAR(force(problem), found.state.force[0] / (rig.friction * rig.row_force()),
                        1e-6);
        }
}

/// F_x/(mu F_N) of Hertz' line contact that slides at one speed of slip [m/s]: Volterra's equation
/// of its temperature, marched from the leading edge by cells that each are solved for themselves.
double sliding_force(const FrictionTemperature& law, double peak_pressure, double slip) {
    constexpr int n = 2000;
    const double h = 2 * rig.half_length / n;
    const double unit = std::sqrt(h / (std::numbers::pi * speed)) /
                        (heat.indenter.effusivity() + heat.substrate.effusivity());
    std::vector<double> flux;
    double force = 0, normal = 0;
    for (int i = 0; i < n; ++i) {
        const double x = (i + .5) * 2 / n - 1, p = peak_pressure * std::sqrt(1 - x * x);
        double before = 20;
        for (int j = 0; j < i; ++j)
            before += 2 * unit * flux[j] * (std::sqrt(i - j + .5) - std::sqrt(i - j - .5));
        double mu = rig.friction;
        for (int k = 0; k < 60; ++k)
            mu = law.coefficient(rig.friction, before + 2 * unit * std::sqrt(.5) * mu * p * slip);
        flux.push_back(mu * p * slip);
        force += mu * p, normal += p;
    }
    return force / (rig.friction * normal);
}

TEST(TemperatureFriction, SlidesAsVolterrasEquationHasIt) {
    constexpr double creepage = 200;
    for (const double change : {-.15, .15}) {
        const FrictionTemperature law = half_at(.4, creepage, change);
        const auto found = steady(row(creepage, law));
        const double expected =
            sliding_force(law, found.state.peak_pressure, creepage * rig.creepage() * speed);
        // Strains are 1/200 of the slip.
        EXPECT_NEAR(found.state.force[0] / (rig.friction * rig.row_force()), expected, 2e-3);
        EXPECT_GT(std::abs(expected - 1), .1);
    }
}

TEST(TemperatureFriction, KnowsTheSteadyStateAlone) {
    const contact::ElasticSubstrate substrate(rig.row_grid());
    rolling::TransientRolling rolling(substrate, row(.6, FrictionTemperature{-.1, 0, 100}));
    rolling.press();
    EXPECT_THROW(rolling.roll(), contact::InputError);
    RollingProblem cold = row(.6, FrictionTemperature{-.1, 0, 100});
    cold.heat.reset();
    EXPECT_THROW(steady(cold), contact::InputError);
}

}  // namespace
}  // namespace tricontact::temperature_friction_test
