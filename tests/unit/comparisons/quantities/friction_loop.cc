// A sphere whose tangential force or shift goes to and fro under one normal force, by the method of
// dimensionality reduction, which has Cattaneo, Mindlin and Deresiewicz' closed forms exactly: on
// each branch the change of the shift is twice the static shift of half the change of the force
// (Masing). The sums over 20 000 springs are those of the integrals to 1e-7.

#include "comparisons/quantities/friction_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/results.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::friction_loop_test {
namespace {

using comparisons::FrictionLoop;
using comparisons::SlipRegime;
using contact::TangentialControl;
namespace quantities = comparisons::quantities;

constexpr double mu = .57, normal_force = 20, tolerance = 1e-6;

/// A sphere of 40 mm on rubber; rows of the drive along x, `steps` from one to the next.
contact::Case case_of(TangentialControl::Kind kind, const std::vector<double>& rows, int steps) {
    contact::Case c;
    c.models = {"mdr"};
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = mu;
    c.of<mdr::Settings>().springs = 20'000;
    c.load.normal_force = normal_force;
    c.load.tangential_force = 0;
    contact::PrescribedPath path;
    for (const double value : rows) {
        contact::PrescribedPath::Row row;
        row.normal.value = normal_force;
        row.tangential[0] = {kind, value};
        row.steps = steps;
        path.rows.push_back(row);
    }
    c.prescribed_path = path;
    return c;
}

contact::History run(const contact::Case& c) {
    return contact::run(c, *mdr::make_model(c));
}

/// U_max [m].
double unit_shift() {
    return contact::half_space_scales(case_of(TangentialControl::Kind::force, {0}, 1)).unit_shift;
}

TEST(FrictionLoop, OfAForceIsThatOfMindlinAndDeresiewicz) {
    const double f = .6, force = f * mu * normal_force, unit = unit_shift();
    const auto c = case_of(TangentialControl::Kind::force, {0, force, -force, force}, 200);
    const auto h = run(c);
    const auto loops = comparisons::friction_loops(c, h);
    ASSERT_EQ(loops.size(), 1u);
    const FrictionLoop& loop = loops.front();
    EXPECT_EQ(loop.regime, SlipRegime::partial_slip);
    EXPECT_TRUE(loop.has_constant_force);
    EXPECT_NEAR(loop.force_amplitude / force, 1, 1e-12);
    const auto u = theory::static_shift_ratio;
    EXPECT_NEAR(loop.shift_amplitude / unit, u(f), tolerance);
    // At F = 0 the branch from f down has come back by twice the shift of f/2.
    EXPECT_NEAR(loop.aperture / unit, 2 * (u(f) - 2 * u(f / 2)), tolerance);
    EXPECT_NEAR(*loop.sliding_ratio(), 1 - 2 * u(f / 2) / u(f), tolerance);
    EXPECT_NEAR(*loop.secant_stiffness() * unit / force, 1 / u(f), tolerance);
    // Everything sticks right after a reversal: dF/dU = 8 a G*/... = (3/2) mu F_N/U_max. Steps of
    // the first order squared: f/100 each.
    EXPECT_NEAR(*loop.tangent_stiffness * unit / (mu * normal_force), 1.5, 1e-4);
}

/// Error of the loop's work with `steps` from row to row, over the closed form.
double work_error(int steps) {
    const double force = .6 * mu * normal_force;
    const auto c = case_of(TangentialControl::Kind::force, {0, force, -force, force}, steps);
    const auto h = run(c);
    const theory::OscillatingForce oscillation{
        mu, normal_force, c.materials().effective_shear_modulus(), h.scales.contact_radius, .6};
    const comparisons::Results results(c, h);
    return results.number(quantities::dissipation).value() /
               theory::cycle_dissipation(oscillation) -
           1;
}

// Springs slip one after the other: their work is exact however many steps are taken.
TEST(FrictionLoop, ItsWorkIsMindlinAndDeresiewiczs) {
    for (const int steps : {1, 10}) EXPECT_NEAR(work_error(steps), 0, tolerance) << steps;
}

// F_N and the shift change in turn, a quarter of a cycle apart: half the steps leave a quarter of
// the error.
TEST(FrictionLoop, ItsWorkIsOfTheSecondOrderWhereTheNormalForceChanges) {
    const double unit = unit_shift();
    const auto work = [&](int steps) {
        auto c = case_of(TangentialControl::Kind::shift,
                         {0, .4 * unit, .8 * unit, .4 * unit, 0, .4 * unit, .8 * unit}, steps);
        constexpr double forces[] = {20, 28, 20, 12, 20, 28, 20};
        for (std::size_t r = 0; r < std::size(forces); ++r)
            c.prescribed_path->rows[r].normal.value = forces[r];
        c.load.normal_force = 28;
        return run(c).dissipation_per_period.back();
    };
    const double coarse = work(5), middle = work(10), fine = work(20);
    EXPECT_NEAR((coarse - middle) / (middle - fine), 4, 1);
    EXPECT_NEAR(middle / fine, 1, 2e-3);
}

TEST(FrictionLoop, SlidingAddsForceTimesWay) {
    const double unit = unit_shift(), shift = 1.5 * unit;
    const auto c =
        case_of(TangentialControl::Kind::shift, {0, shift, -shift, shift, -shift, shift}, 20);
    const auto h = run(c);
    const auto loops = comparisons::friction_loops(c, h);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(loops.back().regime, SlipRegime::gross_slip);
    EXPECT_NEAR(loops.back().force_amplitude / (mu * normal_force), 1, tolerance);
    EXPECT_NEAR(loops.back().shift_amplitude / shift, 1, 1e-12);
    const theory::OscillatingForce full{mu, normal_force, c.materials().effective_shear_modulus(),
                                        h.scales.contact_radius, 1};
    const double exact = theory::cycle_dissipation(full) + 4 * mu * normal_force * (shift - unit);
    const comparisons::Results results(c, h);
    EXPECT_NEAR(results.number(quantities::dissipation).value() / exact, 1, tolerance);
    EXPECT_EQ(h.dissipation_per_period.size(), 2u);
    EXPECT_NEAR(h.dissipation_per_period[0] / h.dissipation_per_period[1], 1, 1e-10);
    // On a branch the stick area falls linearly, to 0 at 2 U_max; counted in springs, 1e-4 of a.
    EXPECT_NEAR(*loops.back().gross_slip_shift / unit, 2, 2e-3);
    EXPECT_EQ(loops.back().least_stick_area, 0);
}

// A cylinder along y by boundary elements: the edge of the slip zones is cut by 100 cells to either
// side.
TEST(FrictionLoop, OfACylinderIsThatOfMindlinAndDeresiewicz) {
    constexpr double f = .6, force = f * mu * normal_force;
    auto c = case_of(TangentialControl::Kind::force, {0, force, -force, force}, 5);
    c.models = {"bem"};
    c.indenter.shape = contact::Case::Shape::cylinder;
    c.indenter.length = 1;
    c.of<contact::Cells>().per_radius = 100;
    const auto h = contact::run(c, *bem::make_model(c, 1));
    const comparisons::Results results(c, h);
    const double unit =
        std::pow(mu * normal_force, 2) * 2 / (std::numbers::pi * c.materials().effective_modulus());
    EXPECT_NEAR(results.number(quantities::dissipation).value() /
                    (unit * theory::line_cycle_dissipation(f)),
                1, 1e-3);
    EXPECT_NEAR(results.number(quantities::loop_stick_radius).value() / h.scales.contact_radius,
                std::sqrt(1 - f), .01);
    EXPECT_EQ(std::get<SlipRegime>(results[quantities::path_regime]), SlipRegime::partial_slip);
}

TEST(FrictionLoop, StickEndsWhereCattaneoAndMindlinSay) {
    const double f = .6, force = f * mu * normal_force;
    const auto c = case_of(TangentialControl::Kind::force, {0, force, -force, force}, 4);
    const auto h = run(c);
    const comparisons::Results results(c, h);
    EXPECT_NEAR(results.number(quantities::loop_stick_radius).value() / h.scales.contact_radius,
                theory::stick_radius_ratio(f), 1e-3);  // springs on either side
    EXPECT_FALSE(results.number(quantities::gross_slip_shift));
}

// Amplitudes that rise: the third cycle slides, and the regime of the path is mixed.
TEST(FrictionLoop, OfCyclesThatAreNotAlikeTheRegimeIsMixed) {
    const double unit = unit_shift(), little = .5 * unit, far = 1.5 * unit;
    const auto c = case_of(TangentialControl::Kind::shift,
                           {0, little, -little, little, -little, little, -far, far, -far, far}, 8);
    const auto loops = comparisons::friction_loops(c, run(c));
    ASSERT_EQ(loops.size(), 3u);
    EXPECT_EQ(comparisons::common_regime(loops), SlipRegime::mixed);
    EXPECT_EQ(comparisons::regime_change(loops), 3);
    EXPECT_EQ(comparisons::common_regime({loops[0], loops[1]}), SlipRegime::partial_slip);
    EXPECT_FALSE(comparisons::regime_change({loops[0], loops[1]}));
}

// A spring of 1e5 N/m instead of a contact: nothing slips.
TEST(FrictionLoop, WithoutWorkEverythingSticks) {
    const auto c = case_of(TangentialControl::Kind::force, {0, 5, -5, 5}, 4);
    contact::History h = run(c);
    for (auto& step : h.steps) {
        step.shift[0] = step.tangential_force[0] / 1e5;
        step.dissipation = step.slip_area = 0;
    }
    const auto loops = comparisons::friction_loops(c, h);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(loops.front().regime, SlipRegime::stick);
    EXPECT_NEAR(loops.front().aperture / loops.front().shift_amplitude, 0, 1e-12);
    EXPECT_NEAR(*loops.front().tangent_stiffness, 1e5, 1e-4);
    EXPECT_NEAR(*loops.front().secant_stiffness(), 1e5, 1e-4);
}

TEST(FrictionLoop, OfAPathThatDoesNotCloseThereIsNone) {
    const auto c = case_of(TangentialControl::Kind::force, {0, 5, -5, 0}, 4);
    const auto h = run(c);
    EXPECT_TRUE(comparisons::friction_loops(c, h).empty());
    const comparisons::Results results(c, h);
    EXPECT_FALSE(results.number(quantities::dissipation));
    EXPECT_FALSE(results.number(quantities::loop_force));
}

}  // namespace
}  // namespace tricontact::friction_loop_test
