// The steady state of relaxing bodies, solved by itself, beside rolling on and elastic limits.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "bem/model.h"
#include "bem/steady_compliance.h"
#include "bem/steady_model.h"
#include "contact/cells.h"
#include "tests/unit/rolling/problems.h"

namespace tricontact::steady_relaxing_test {
namespace {

using rolling::RollingProblem;
using rolling::RollingState;
using rolling_test::Rig;

constexpr double relaxation_time = .3;

/// A half-space that relaxes as one, which the rig rolls over in `way` half lengths a relaxation.
bem::SteadyGridCompliance steady_half_space(const Rig& rig, bool sphere, double ratio, double way) {
    const int beside = static_cast<int>(1.25 * rig.n) + 3, beside_y = sphere ? rig.n + 3 : 0;
    auto grid = contact::ContactPoints::grid(2 * beside + 1, 2 * beside_y + 1,
                                             {-beside * rig.cell(), -beside_y * rig.cell()},
                                             {rig.cell(), sphere ? rig.cell() : rig.row_length()});
    if (!sphere) grid.line_length = rig.row_length();
    const bem::RectangleInfluence cell(rig.materials(), grid.spacing[0], grid.spacing[1]);
    return {{[cell](double x, double y) { return cell.at(x, y); }},
            {{}, {contact::Retardation({{{ratio, relaxation_time}}}, 0)}, {1}},
            way * rig.half_length / relaxation_time,
            std::move(grid),
            bem::is_coupled(rig.materials())};
}

/// Relaxation from slight to nearly all, as the contact is slow, or fast.
void expect_sound(Rig rig, bool sphere) {
    for (const double poisson : {.5, .2})
        for (const double ratio : {.1, 2., 100.})
            for (const double way : {1e-3, .1, 1., 1e3}) {
                rig.substrate.poisson = poisson;
                RollingProblem problem = sphere ? rig.sphere(.6) : rig.row(.6);
                problem.tolerance = 1e-7;
                const auto steady =
                    rolling::steady_rolling(steady_half_space(rig, sphere, ratio, way), problem);
                EXPECT_TRUE(steady.audit.passed()) << poisson << ' ' << ratio << ' ' << way;
                EXPECT_GE(steady.state.material_dissipation, 0);
            }
}

TEST(SteadyRelaxing, ConvergesOfCylinders) {
    expect_sound({.n = 20}, false);
}

TEST(SteadyRelaxing, ConvergesOfSpheres) {
    expect_sound({.n = 8}, true);
}

TEST(SteadyRelaxing, PressesToAPrescribedDepthAsUnderItsForce) {
    const Rig rig{.n = 10};
    const auto compliance = steady_half_space(rig, true, 2, .5);
    RollingProblem problem = rig.sphere(.3);
    const auto pressed = rolling::steady_rolling(compliance, problem).state;
    problem.normal = {contact::NormalControl::Kind::indentation, pressed.indentation};
    EXPECT_NEAR(
        rolling::steady_rolling(compliance, problem).state.normal_force / pressed.normal_force, 1,
        1e-7);
}

// Elastic but for one part in the way over the contact, or its inverse.
TEST(SteadyRelaxing, SlowOrFastItIsElastic) {
    constexpr double ratio = 2;
    const Rig rig{.n = 10};
    const RollingProblem problem = rig.sphere(.6);
    for (const bool fast : {false, true}) {
        const auto relaxing = steady_half_space(rig, true, ratio, fast ? 1e6 : 1e-6);
        const contact::Material material{(fast ? 1 + ratio : 1) * rig.substrate.young,
                                         rig.substrate.poisson};
        const auto elastic = bem::half_space_compliance({{}, material}, relaxing.points(), 1);
        const auto one = rolling::steady_rolling(relaxing, problem).state,
                   other = rolling::steady_rolling(*elastic, problem).state;
        EXPECT_NEAR(one.indentation / other.indentation, 1, 1e-4);
        EXPECT_NEAR(one.creepage.longitudinal / other.creepage.longitudinal, 1, 1e-4);
        EXPECT_NEAR(one.dissipation / other.dissipation, 1, 1e-4);
    }
}

/// A sphere that spins on rubber whose bulk is elastic, coupled: all kernels, and both substrates
/// take the same steps. What rolling on errs by is what its grid does not see ahead.
TEST(SteadyRelaxing, IsWhereRollingOnEnds) {
    contact::Case c;
    c.substrate = {3e6, .2};
    c.relaxation = {{{1, relaxation_time}}, contact::Relaxation::Bulk::elastic};
    c.indenter.radius = .07;
    c.friction.coefficient = .35;
    const Rig rig{.substrate = c.substrate, .n = 3};
    c.load.normal_force = rig.sphere_force();
    c.tractive_rolling.emplace();
    c.tractive_rolling->speed = .5 * rig.half_length / relaxation_time;
    c.of<contact::Cells>().per_radius = rig.n;

    RollingProblem problem = rig.sphere(.4);
    problem.drive.creepage[1] = .2 * rig.creepage();
    problem.drive.spin = .4 * rig.friction / rig.radius;
    problem.speed = c.tractive_rolling->speed;
    problem.tolerance = 1e-8;
    const auto direct =
        rolling::steady_rolling(*bem::steady_compliance(c, 1, bem::Body::half_space), problem);
    EXPECT_TRUE(direct.audit.passed());
    const RollingState& steady = direct.state;
    const RollingState last =
        rolling_test::rolled_from_rest(*bem::make_substrate(c, 1, bem::Body::half_space), problem,
                                       24 * rig.half_length)
            .back();
    constexpr double allowed = 1e-4;
    const double limit = rig.friction * steady.normal_force;
    EXPECT_NEAR(last.creepage.longitudinal / rig.creepage(),
                steady.creepage.longitudinal / rig.creepage(), allowed);
    EXPECT_NEAR(last.force[1] / limit, steady.force[1] / limit, allowed);
    EXPECT_NEAR(last.spin_moment / (limit * rig.half_length),
                steady.spin_moment / (limit * rig.half_length), allowed);
    EXPECT_NEAR(last.indentation / steady.indentation, 1, allowed);
    EXPECT_NEAR(last.pressure_lead / rig.half_length, steady.pressure_lead / rig.half_length,
                allowed);
    EXPECT_NEAR(last.dissipation / steady.dissipation, 1, 10 * allowed);
    // Here what the branches lose on the grid, which ends behind the contact, of three cells in a.
    EXPECT_NEAR(last.material_dissipation / steady.material_dissipation, 1, .05);
    EXPECT_GT(steady.pressure_lead, .03 * rig.half_length);
}

}  // namespace
}  // namespace tricontact::steady_relaxing_test
