// Layers of elements that a body attracts and whose interface carries a shear strength, shifted and
// rolled: against the exact adhesive radius, the limit of a lens that stays, and boundary elements.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "fem/case/model.h"
#include "fem/settings.h"
#include "tests/unit/adhesive_ball.h"
#include "theory/adhesive/adhesive_layer.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::fem_adhesive_friction_test {
namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;
using std::numbers::pi;
using test::AdhesiveBall;
using theory::strength_rolling;

constexpr double strength = 2e3, elements = 3;

/// On a layer as thick as the radius at which it lets go of a half-space; pressed to this depth.
AdhesiveBall pressed_ball(double depth) {
    AdhesiveBall ball(0, depth, .3);
    const double a_off = std::cbrt(1.5) * ball.radius();
    ball.c.layer.thickness = a_off;
    ball.c.friction.shear_strength = strength;
    ball.c.of<fem::Settings>().size = a_off / elements;
    ball.c.of<fem::Settings>().cache = "none";
    return ball;
}

double exact_radius(const AdhesiveBall& ball) {
    const auto body = ball.c.make_axisymmetric_indenter();
    return theory::layer_curve({ball.c.substrate, *ball.c.layer.thickness}, *body, ball.w)
        .follow({}, {NormalControl::Kind::indentation, *ball.c.load.indentation})
        .state.radius;
}

// The area to a quarter of a node's distance in its radius. A state that goes on from its bytes, at
// another place, is what would have gone on.
TEST(FemAdhesiveFrictionSlow, ShiftsOverTheAdhesiveAreaAndGoesOnFromItsState) {
    AdhesiveBall ball = pressed_ball(.4);
    Case& c = ball.c;
    c.rolling.emplace();
    c.rolling->amplitude = .2 * ball.radius();
    const auto model = fem::make_model(c, {});
    LoadStep step;
    step.normal = {NormalControl::Kind::indentation, *c.load.indentation};
    model->advance(step);
    const double a = exact_radius(ball), limit = model->scales().sliding_force;
    EXPECT_NEAR(std::sqrt(limit / (pi * strength)) / a, 1, .03);
    step.tangential[0] = {TangentialControl::Kind::force, .5 * limit};
    const auto shifted = model->advance(step);
    EXPECT_NEAR(shifted.tangential_force[0] / limit, .5, 1e-9);
    EXPECT_EQ(shifted.may_differ, false);
    const auto second = model->sibling(c.contact);
    step.offset = {.1 * ball.radius(), 0};
    model->advance(step);
    second->read_state(model->write_state());
    step.offset = {-.1 * ball.radius(), 0};
    const auto r = model->advance(step), other = second->advance(step);
    EXPECT_EQ(r.shift[0], other.shift[0]);
    EXPECT_EQ(r.normal_force, other.normal_force);
    EXPECT_TRUE(model->audit().passed());
}

// The contact moves along nearly as it is, between nodes: the force of a depth changes by a percent
// of pi w R, and the limit is that of a lens that stays.
TEST(FemAdhesiveFrictionSlow, RollsAsCells) {
    AdhesiveBall ball = pressed_ball(.4);
    Case& c = ball.c;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .25;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    c.rolling->steps_per_quarter = 2;
    c.rolling->periods = 8;
    const double limit = strength_rolling.exact_limit(.25);
    c.load.tangential_ratio = .7 * limit;
    const auto history = contact::run(c, *fem::make_model(c, {}));
    EXPECT_NEAR(history.limit_tangential_ratio, limit, .02);
    EXPECT_EQ(history.verdict.state, contact::State::shakedown);
    double most = 0, least = 0;
    for (const auto& now : history.steps) {
        const double off = (now.normal_force - history.steps.front().normal_force) / ball.force();
        most = std::max(most, off);
        least = std::min(least, off);
        if (now.phase > 0) {
            EXPECT_LT(std::abs(now.released_energy),
                      1e-3 * ball.w * pi * ball.radius() * ball.radius());
        }
    }
    EXPECT_LT(most - least, .05);
    EXPECT_TRUE(history.audit.passed());

    // Cells as far apart as the nodes.
    c.of<contact::Cells>().spacing = *c.of<fem::Settings>().size / 2;
    const auto cells = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_NEAR(history.scales.contact_radius / cells.scales.contact_radius, 1, .01);
    EXPECT_NEAR(history.static_shift / cells.static_shift, 1, .02);
    EXPECT_NEAR(history.shift_per_period.back() / cells.shift_per_period.back(), 1, .02);
}

}  // namespace
}  // namespace tricontact::fem_adhesive_friction_test
