// Adhesive springs by the formulas of Johnson, Kendall and Roberts, and those of a layer by the
// exact integral equation.

#include "mdr/adhesive_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#include "theory/adhesive/adhesive_layer.h"

namespace tricontact::adhesive_model_test {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using std::numbers::pi;

constexpr double radius = 5e-3, young = 1.5e6, work = .06;

Case pressed(double force, double nu = .5) {
    Case c;
    c.indenter.radius = radius;
    c.substrate = {young, nu};
    c.friction.coefficient = .5;
    c.adhesion = contact::Adhesion{.work = work, .range = 0};
    c.load.normal_force = force;
    c.load.tangential_ratio = 0;
    return c;
}

LoadStep step_of(NormalControl::Kind kind, double value) {
    LoadStep step;
    step.normal = {kind, value};
    return step;
}
constexpr auto by_force = NormalControl::Kind::force, by_depth = NormalControl::Kind::indentation;

// a^3 = 3 R/(4 E*) (F + 3 pi w R + sqrt(6 pi w R F + (3 pi w R)^2)), pull-off at -3/2 pi w R and
// a^3 = 9 pi w R^2/(8 E*): 10000 springs leave 1e-8.
TEST(AdhesiveModel, IsThatOfJohnsonKendallAndRoberts) {
    const Case c = pressed(.02);
    const auto model = mdr::make_model(c);
    const double modulus = c.materials().effective_modulus(), unit = pi * work * radius;
    for (const double f : {.02, .004, 0., -.4 * unit, -1.4 * unit}) {
        model->advance(step_of(by_force, f));
        const double cube =
            3 * radius / (4 * modulus) * (f + 3 * unit + std::sqrt(6 * unit * f + 9 * unit * unit));
        EXPECT_NEAR(model->scales().contact_radius / std::cbrt(cube), 1, 1e-6) << f;
    }
    EXPECT_THROW(model->advance(step_of(by_force, -1.501 * unit)), contact::InputError);
    const auto off = model->pull_off();
    EXPECT_NEAR(off->force / (1.5 * unit), 1, 1e-6);
    EXPECT_NEAR(off->radius / std::cbrt(9 * pi * work * radius * radius / (8 * modulus)), 1, 1e-6);
    EXPECT_TRUE(model->audit().passed());
}

// Under depth: jump in at 0, jump off at -3/4 (pi^2 w^2 R/E*^2)^(1/3) with -5/6 pi w R; what is
// lost is what the force has done, by steps that end next to the jumps.
TEST(AdhesiveModel, LoopUnderDepthLosesItsWorkInTwoJumps) {
    const Case c = pressed(.02);
    const auto model = mdr::make_model(c);
    const double modulus = c.materials().effective_modulus();
    const double unit = std::cbrt(std::pow(pi * work / modulus, 2) * radius);
    EXPECT_EQ(model->advance(step_of(by_depth, -unit)).contact_area, 0);
    double lost = model->advance(step_of(by_depth, 0)).released_energy, done = 0;
    EXPECT_GT(lost, 0);
    auto before = model->advance(step_of(by_depth, 0));
    const int n = 400;
    const auto go = [&](double from, double to) {
        for (int k = 1; k <= n; ++k) {
            const auto now = model->advance(step_of(by_depth, from + (to - from) * k / n));
            done += (now.normal_force + before.normal_force) / 2 *
                    (now.indentation - before.indentation);
            lost += now.released_energy;
            before = now;
        }
    };
    const double last = -.75 * unit * (1 - 1e-9);
    go(0, 3 * unit);
    go(3 * unit, last);
    EXPECT_NEAR(before.normal_force / (-5. / 6 * pi * work * radius), 1, 1e-3);
    EXPECT_EQ(before.may_differ, 1);
    const auto apart = model->advance(step_of(by_depth, 1.01 * last));
    EXPECT_EQ(apart.contact_area, 0);
    lost += apart.released_energy;
    EXPECT_NEAR(done / lost, 1, 1e-3);
    EXPECT_TRUE(model->audit().passed());
}

// The elements of a layer against the integral equation, b/a of pull-off from 3 to .3.
TEST(AdhesiveModel, OnALayerIsTheExactOne) {
    const contact::Paraboloid body(radius);
    for (const double nu : {.3, .5})
        for (const double thickness : {2e-4, 2e-3}) {
            Case c = pressed(.02, nu);
            c.layer.thickness = thickness;
            const auto model = mdr::make_layer_model(c);
            auto exact = theory::layer_curve({c.substrate, thickness}, body, work);
            EXPECT_NEAR(model->pull_off()->force / exact.pull_off().force, 1, 1e-4);
            const auto r = model->advance(step_of(by_force, .02));
            const auto s = exact.follow({}, {by_force, .02}).state;
            EXPECT_NEAR(r.indentation / s.indentation, 1, 2e-4) << nu << ' ' << thickness;
            EXPECT_NEAR(model->scales().contact_radius / s.radius, 1, 2e-4);
            EXPECT_NEAR(r.stored_energy / s.energy, 1, 1e-3);
        }
}

// Tractions carry F, their tension at the edge included; 1e-2 of what is drawn.
TEST(AdhesiveModel, ShowsTensionBesideTheEdge) {
    const auto model = mdr::make_model(pressed(.002));
    model->advance(step_of(by_force, .002));
    const auto s = model->surface();
    EXPECT_GT(s.normal_traction[s.n_x / 2], 0);
    EXPECT_LT(*std::ranges::min_element(s.normal_traction), -s.normal_traction[s.n_x / 2]);
    double force = 0;
    for (const double q : s.normal_line_load) force += q * s.spacing[0];
    EXPECT_NEAR(force / .002, 1, .05);
}

TEST(AdhesiveModel, RefusesWhatDoesNotPress) {
    const auto model = mdr::make_model(pressed(.02));
    LoadStep step = step_of(by_force, .02);
    step.tangential[0].value = 1e-3;
    EXPECT_THROW(model->advance(step), contact::InputError);
}

}  // namespace tricontact::adhesive_model_test
