// Cells that attract each other and carry a shear strength where they touch, shifted and rolled, on
// the half-space whose directions do not couple: springs over the adhesive radius.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "theory/adhesive/adhesive_curve.h"
#include "theory/adhesive/maugis_dugdale.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::bem_adhesive_friction_test {
namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;
using std::numbers::pi;
using theory::strength_rolling;

constexpr double body_radius = .01, work = .05, strength = 2e3;

/// Radii over (pi w R^2/K)^(1/3), depths over its square over R, as Maugis has them; `lambda` 0:
/// no range. Cells per unit of the radius.
struct Ball {
    Case c;
    double unit;

    Ball(double lambda, double cells, double depth) {
        c.indenter.radius = body_radius;
        c.substrate = {1e6, .5};
        c.friction.shear_strength = strength;
        const double K = 4. / 3 * c.materials().effective_modulus();
        unit = std::cbrt(pi * work * body_radius * body_radius / K);
        c.load.indentation = depth * unit * unit / body_radius;
        c.load.tangential_ratio = 0;
        c.of<contact::Cells>().spacing = unit / cells;
        c.adhesion = contact::Adhesion{.work = work};
        if (lambda > 0)
            c.adhesion->peak_stress = lambda / 2 * std::cbrt(pi * work * K * K / body_radius);
    }
    /// [m]
    double exact_radius(double lambda) const {
        const double depth = *c.load.indentation;
        if (lambda > 0)
            return unit *
                   theory::maugis_contact_at(lambda, depth * body_radius / (unit * unit)).radius;
        const contact::Paraboloid body(body_radius);
        return theory::half_space_curve(body, c.materials().effective_modulus(), work)
            .follow({}, {NormalControl::Kind::indentation, depth})
            .state.radius;
    }
};

// F/(pi tau_0 a^2) = 2/pi [u sqrt(1 - u^2) + arcsin u]; the error of the traction that falls beside
// the last slipping cell, .015 of it, as without adhesion; the area to half a cell of its radius.
TEST(BemAdhesiveFriction, ShiftsAsAStrengthOverTheAdhesiveRadius) {
    for (const auto& [lambda, cells] : {std::pair{0., 10.}, {1., 20.}}) {
        const Ball ball(lambda, cells, .2);
        const auto model = bem::make_model(ball.c, 1);
        LoadStep step;
        step.normal = {NormalControl::Kind::indentation, *ball.c.load.indentation};
        model->advance(step);
        const double a = ball.exact_radius(lambda), limit = model->scales().sliding_force;
        EXPECT_NEAR(std::sqrt(limit / (pi * strength)) / a, 1, .5 * ball.unit / cells / a)
            << lambda;
        const double shear = ball.c.materials().effective_shear_modulus();
        for (const double f : {.3, .7, .95}) {
            step.tangential[0] = {TangentialControl::Kind::force, f * limit};
            const auto r = model->advance(step);
            const double u = r.shift[0] * shear / (2 * strength * a);
            EXPECT_NEAR(strength_rolling.static_force(u), f, .015) << lambda;
            EXPECT_NEAR(r.tangential_force[0] / limit, f, 1e-9);
        }
        EXPECT_TRUE(model->audit().passed());
    }
}

// The contact moves along as it is: same force, nothing lost, the limit of the lens that stays.
TEST(BemAdhesiveFriction, RollsUnchanged) {
    Ball ball(0, 8, .2);
    Case& c = ball.c;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .25;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    c.rolling->steps_per_quarter = 2;
    c.rolling->periods = 12;
    const double limit = strength_rolling.exact_limit(.25);
    c.load.tangential_ratio = .7 * limit;
    const auto model = bem::make_model(c, 1);
    const auto history = contact::run(c, *model);
    EXPECT_NEAR(history.limit_tangential_ratio, limit, .02);
    EXPECT_EQ(history.verdict.state, contact::State::shakedown);
    // As the body without attraction, pressed until its contact is as wide.
    Case plain = c;
    const double a = ball.exact_radius(0);
    plain.adhesion.reset();
    plain.load.indentation = a * a / body_radius;
    const auto other = contact::run(plain, *bem::make_model(plain, 1));
    EXPECT_NEAR(history.scales.contact_radius / other.scales.contact_radius, 1, 5e-3);
    EXPECT_NEAR(history.static_shift / other.static_shift, 1, .02);
    EXPECT_NEAR(history.shift_per_period.back() / other.shift_per_period.back(), 1, .02);
    const double force = history.steps.front().normal_force;
    for (const auto& step : history.steps) {
        EXPECT_NEAR(step.normal_force / force, 1, 5e-3);
        EXPECT_LT(std::abs(step.released_energy), step.phase > 0 ? 1e-12 : 1);
    }
    EXPECT_TRUE(history.audit.passed());
}

// What goes on from the bytes of a state, at another place, is what would have gone on.
TEST(BemAdhesiveFriction, GoesOnFromItsState) {
    const Ball ball(0, 8, .2);
    const auto first = bem::make_model(ball.c, 1), second = bem::make_model(ball.c, 1);
    LoadStep step;
    step.normal = {NormalControl::Kind::indentation, *ball.c.load.indentation};
    first->advance(step);
    step.tangential[0] = {TangentialControl::Kind::force, .5 * first->scales().sliding_force};
    step.offset = {.1 * ball.unit, 0};
    first->advance(step);
    second->read_state(first->write_state());
    step.offset = {-.1 * ball.unit, 0};
    step.normal.value = 0;
    const auto r = first->advance(step), other = second->advance(step);
    EXPECT_EQ(r.shift[0], other.shift[0]);
    EXPECT_EQ(r.normal_force, other.normal_force);
    EXPECT_EQ(r.force_residual, other.force_residual);
}

}  // namespace
}  // namespace tricontact::bem_adhesive_friction_test
