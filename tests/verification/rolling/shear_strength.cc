// Bodies in steady rolling whose interface has a shear strength tau_0 in the place of mu p: a
// cylinder against the closed form of theory/creep_law.h over three grids, a ball at small
// creepages against Kalker's linear theory, and laws where they are Coulomb's.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "rolling/run.h"
#include "tests/unit/rolling/problems.h"
#include "theory/creep_law.h"
#include "theory/rolling/kalker.h"

namespace tricontact::rolling_shear_strength_test {
namespace {

using rolling_test::Rig;

constexpr double strength = 3e4;              // tau_0 [Pa]
constexpr std::array grids = {80, 160, 320};  // cells per half length

rolling::SteadyRolling roll(double f, int n) {
    const Rig rig{.n = n};
    rolling::RollingProblem problem = rig.row(0);
    problem.friction = contact::Friction{.shear_strength = strength}.law();
    problem.drive.force_ratio = f;
    return rolling::steady_rolling(*rig.row_grid(), problem);
}

double creepage_ratio(const rolling::RollingState& s) {
    return std::numbers::pi * Rig{}.modulus() * s.creepage.longitudinal / (4 * strength);
}

// As Carter's: the slip of a cell is a difference to the next one, half a cell ahead.
TEST(RollingShearStrength, CylinderCreepsAsTheClosedFormAtFirstOrder) {
    for (const double f : {.2, .5, .8}) {
        std::vector<double> error;
        for (const int n : grids) {
            const rolling::SteadyRolling rolled = roll(f, n);
            EXPECT_TRUE(rolled.audit.passed());
            error.push_back(creepage_ratio(rolled.state) / theory::strength_creepage_ratio(f) - 1);
            EXPECT_NEAR(rolled.state.stick_area / rolled.state.contact_area,
                        theory::strength_stick_ratio(f), 2. / n);
        }
        for (std::size_t k = 1; k < error.size(); ++k)
            EXPECT_NEAR(std::log2(error[k - 1] / error[k]), 1, .05) << f;
        EXPECT_LT(std::abs(error.back()), 2e-3) << f;
        EXPECT_NEAR(2 * error[2] - error[1], 0, 2e-5) << f;
    }
}

// Away from its roots, at the leading edge and where the slip zone begins.
TEST(RollingShearStrength, TractionIsThatOfTheClosedForm) {
    for (const double f : {.3, .7}) {
        std::vector<double> worst;
        for (const int n : grids) {
            const auto s = roll(f, n).surface;
            const double begin = 1 - 2 * theory::strength_stick_ratio(f);
            double largest = 0;
            for (int i = 0; i < s.n_x; ++i) {
                const double x = s.x(i) / Rig{}.half_length;
                if (std::abs(x) > .95 || std::abs(x - begin) < .1) continue;
                largest = std::max(largest, std::abs(s.tangential_traction_x[i] / strength -
                                                     theory::strength_traction(x, f)));
            }
            worst.push_back(largest);
        }
        EXPECT_NEAR(worst[2] / worst[0], .25, .05) << f;
        EXPECT_LT(worst[2], 3e-3) << f;
    }
}

// No creepage makes all slide: what comes in must be strained first.
TEST(RollingShearStrength, SomethingSticksAtAnyCreepage) {
    const Rig rig{.n = 160};
    rolling::RollingProblem problem = rig.row(0);
    problem.friction = contact::Friction{.shear_strength = strength}.law();
    for (const double ratio : {.5, 1.5, 2.5}) {
        problem.drive.creepage[0] = 4 * strength / (std::numbers::pi * rig.modulus()) * ratio;
        const auto s = rolling::steady_rolling(*rig.row_grid(), problem).state;
        const double f = s.force[0] / s.friction_bound;
        EXPECT_NEAR(f, theory::strength_force_ratio(ratio), 4e-3) << ratio;
        EXPECT_GT(s.stick_area, 0);
    }
}

// Where friction moves the gap, a point at the edge may find no rest: pressed, it carries tau_0 and
// is lifted off. The iteration ends all the same, and balances.
TEST(RollingShearStrength, CoupledEdgesComeToRest) {
    Rig rig{.n = 12};
    rig.substrate.poisson = .2;
    rolling::RollingProblem problem = rig.sphere(0);
    problem.friction = contact::Friction{.shear_strength = 3e5}.law();
    problem.drive.force_ratio = .56;
    problem.tolerance = 1e-7;
    const int beside = 2 * rig.n;  // friction moves the contact aside
    const auto grid = bem::half_space_compliance(
        rig.materials(),
        contact::ContactPoints::grid(2 * beside + 1, 2 * beside + 1,
                                     {-beside * rig.cell(), -beside * rig.cell()},
                                     {rig.cell(), rig.cell()}),
        1);
    const auto rolled = rolling::steady_rolling(*grid, problem);
    EXPECT_TRUE(rolled.audit.passed());
    EXPECT_NEAR(rolled.state.force[0] / rolled.state.friction_bound, .56, 1e-6);
}

// Laws where they are Coulomb's, on a ball: a cap above all pressures, a strength far below them.
TEST(RollingShearStrength, LimitCasesAreCoulombs) {
    const Rig rig{.n = 12};
    const auto rolled = [&](const contact::Friction& friction) {
        rolling::RollingProblem problem = rig.sphere(0);
        problem.friction = friction.law();
        problem.drive.force_ratio = .6;
        return rolling::steady_rolling(*rig.sphere_grid(), problem).state.creepage.longitudinal;
    };
    const double coulomb = rolled({.coefficient = rig.friction});
    const contact::Friction near[] = {
        {.coefficient = rig.friction, .shear_strength = 1e-3},
        {.coefficient = rig.friction, .pressure_exponent = 1 - 1e-9, .reference_pressure = 1e5},
        {.coefficient = rig.friction, .strength_limit = 1e9}};
    for (const contact::Friction& friction : near)
        EXPECT_NEAR(rolled(friction) / coulomb, 1, 1e-6) << friction.formula();
}

// While nearly all sticks the force over the creepage is that of Kalker's linear theory, whatever
// the law. A cell of a/24 more: first order, as under Coulomb's law (RollingKalker.*).
TEST(RollingShearStrength, SmallCreepagesAreKalkersLinearTheory) {
    const Rig rig{.n = 24};
    const auto slope = [&](const contact::Friction& friction) {
        rolling::RollingProblem problem = rig.sphere(0);
        problem.friction = friction.law();
        problem.drive.creepage = {1e-5 * rig.creepage(), 0.};
        const auto s = rolling::steady_rolling(*rig.sphere_grid(), problem).state;
        return s.force[0] / s.creepage.longitudinal;
    };
    const theory::CombinedMaterial material = theory::combined_material(rig.materials());
    const double a = rig.half_length,
                 kalker = material.shear_modulus * a * a *
                          theory::kalker_coefficients(1, material.poisson).longitudinal;
    const double coulomb = slope({.coefficient = rig.friction});
    EXPECT_NEAR(slope({.shear_strength = strength}) / kalker, 1, .05);
    EXPECT_NEAR(slope({.shear_strength = strength}) / coulomb, 1, .02);
}

}  // namespace
}  // namespace tricontact::rolling_shear_strength_test
