// Friction by a shear strength over an adhesive contact, shifted and rolled back and forth, by the
// formulas of springs over JKR's radius; hysteresis of adhesion by the punch of a held edge.

#include "mdr/adhesive_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/run.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#include "theory/adhesive/adhesive_layer.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::adhesive_friction_test {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;
using std::numbers::pi;
using theory::strength_rolling;

constexpr double radius = 5e-3, young = 1.5e6, work = .06, strength = 4e4;

Case sliding(double force, double nu = .5) {
    Case c;
    c.indenter.radius = radius;
    c.substrate = {young, nu};
    c.friction.shear_strength = strength;
    c.adhesion = contact::Adhesion{.work = work, .range = 0};
    c.load.normal_force = force;
    c.load.tangential_ratio = .5;
    return c;
}

/// a^3 = 3 R/(4 E*) (F + 3 pi w R + sqrt(6 pi w R F + (3 pi w R)^2)).
double jkr_radius(const Case& c, double force) {
    const double unit = pi * work * radius;
    return std::cbrt(3 * radius / (4 * c.materials().effective_modulus()) *
                     (force + 3 * unit + std::sqrt(6 * unit * force + 9 * unit * unit)));
}

LoadStep pulled_along(double force, TangentialControl along) {
    LoadStep step;
    step.normal = {NormalControl::Kind::force, force};
    step.tangential[0] = along;
    return step;
}

// F = tau_0 pi a^2 2/pi [u sqrt(1 - u^2) + arcsin u], u = U G*/(2 tau_0 a), under forces of either
// sign: springs of 1e-4 of the bed leave 1e-4.
TEST(AdhesiveFriction, StaticShiftIsThatOfAStrengthOverTheAdhesiveRadius) {
    const Case c = sliding(.005);
    const double shear = c.materials().effective_shear_modulus();
    const auto model = mdr::make_model(c);
    for (const double force : {.005, 0., -.001}) {
        model->release();
        model->advance(pulled_along(.005, {TangentialControl::Kind::shift, 0}));
        model->advance(pulled_along(force, {TangentialControl::Kind::shift, 0}));
        const double a = jkr_radius(c, force), unit = 2 * strength * a / shear;
        EXPECT_NEAR(model->scales().unit_shift / unit, 1, 1e-3);
        EXPECT_NEAR(model->scales().sliding_force / (pi * a * a * strength), 1, 1e-3);
        for (const double u : {.2, .6, .95}) {
            const auto r =
                model->advance(pulled_along(force, {TangentialControl::Kind::shift, u * unit}));
            EXPECT_NEAR(r.tangential_force[0] / (pi * a * a * strength),
                        strength_rolling.static_force(u), 2e-4)
                << force << ' ' << u;
        }
        EXPECT_TRUE(model->audit().passed());
    }
}

// As adhesion vanishes the contact is the one without it.
TEST(AdhesiveFriction, WithoutAdhesionIsTheKnownOne) {
    Case c = sliding(.02);
    c.adhesion->work = 1e-9;
    const auto attracted = mdr::make_model(c);
    c.adhesion.reset();
    const auto plain = mdr::make_model(c);
    for (auto* model : {attracted.get(), plain.get()})
        model->advance(pulled_along(.02, {TangentialControl::Kind::shift, 0}));
    const TangentialControl along{TangentialControl::Kind::shift, 1e-6};
    const auto r = attracted->advance(pulled_along(.02, along)),
               other = plain->advance(pulled_along(.02, along));
    EXPECT_NEAR(r.tangential_force[0] / other.tangential_force[0], 1, 1e-4);
    EXPECT_NEAR(r.stored_energy / other.stored_energy, 1, 1e-4);
}

/// Rolled by w a at f of the limit.
contact::History rolled(const Case& pressed, const char* name, double w, double f) {
    Case c = pressed;
    c.load.tangential_ratio = f;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    c.rolling->periods = 60;
    const auto model = std::string(name) == "mdr" ? mdr::make_model(c) : mdr::make_layer_model(c);
    return contact::run(c, *model);
}

// f_lim = 2/pi (arccos w - w sqrt(1 - w^2)) with w = W/a of JKR's radius, and the settled shift
// of kappa = 4/pi; under a force that hardly presses Hertz' radius is far off.
TEST(AdhesiveFriction, RollsAsAStrengthOverTheAdhesiveRadius) {
    const Case c = sliding(2e-4);
    for (const double w : {.1, .3}) {
        const double limit = strength_rolling.exact_limit(w), f = .8 * limit;
        const auto history = rolled(c, "mdr", w, f);
        EXPECT_NEAR(history.scales.contact_radius / jkr_radius(c, 2e-4), 1, 1e-6);
        EXPECT_NEAR(history.limit_tangential_ratio, limit, 1e-3);
        EXPECT_EQ(history.verdict.state, contact::State::shakedown);
        EXPECT_NEAR(history.shift_per_period.back() / history.scales.unit_shift,
                    *strength_rolling.settled_shift_ratio(w, f, strength_rolling.mdr_mapping),
                    2e-3);
        // It closes in front as it opens behind: nothing is lost along the normal.
        for (const auto& step : history.steps) {
            EXPECT_EQ(step.released_energy, step.phase > 0 ? 0 : step.released_energy);
            EXPECT_NEAR(step.normal_force / 2e-4, 1, 1e-9);
        }
        EXPECT_EQ(rolled(c, "mdr", w, 1.05 * limit).verdict.state, contact::State::ratcheting);
    }
}

// On a layer: the radius by the integral equation, the limit of its strength, which asks for
// nothing but the radius. Elements of 1/100 leave 1 % of the limit.
TEST(AdhesiveFriction, OnALayerHasTheLimitOfItsRadius) {
    Case c = sliding(2e-3);
    c.layer.thickness = 3e-4;
    const contact::Paraboloid body(radius);
    auto exact = theory::layer_curve({c.substrate, 3e-4}, body, work);
    const double a = exact.follow({}, {NormalControl::Kind::force, 2e-3}).state.radius;
    const auto history = rolled(c, "mdr-layer", .3, .5);
    EXPECT_NEAR(history.scales.contact_radius / a, 1, 2e-4);
    EXPECT_NEAR(history.friction_limit / (pi * a * a * strength), 1, 1e-3);
    EXPECT_NEAR(history.limit_tangential_ratio, strength_rolling.exact_limit(.3), 5e-3);
    EXPECT_TRUE(history.audit.passed());
}

// Along the surface work is stored or dissipated: the sum of force times shift over a loop of
// shifts is the dissipation, within the trapezoidal rule of 40 steps.
TEST(AdhesiveFriction, LoopOfShiftsDissipatesItsWork) {
    const Case c = sliding(1e-3);
    const auto model = mdr::make_model(c);
    const double unit =
        2 * strength * jkr_radius(c, 1e-3) / c.materials().effective_shear_modulus();
    auto before = model->advance(pulled_along(1e-3, {TangentialControl::Kind::shift, 0}));
    const double start = before.stored_energy;
    double done = 0, dissipated = 0;
    const auto go = [&](double from, double to) {
        for (int k = 1; k <= 40; ++k) {
            const auto r = model->advance(pulled_along(
                1e-3, {TangentialControl::Kind::shift, unit * (from + (to - from) * k / 40)}));
            done += (r.tangential_force[0] + before.tangential_force[0]) / 2 *
                    (r.shift[0] - before.shift[0]);
            dissipated += r.dissipation;
            before = r;
        }
    };
    go(0, 2);
    go(2, -1);
    EXPECT_NEAR(done / (dissipated + before.stored_energy - start), 1, 2e-3);
}

TEST(AdhesiveFriction, IsLostOnlyWithoutALoad) {
    Case c = sliding(1e-3);
    c.load.normal_force.reset();
    c.load.indentation = 5e-6;
    const auto model = mdr::make_model(c);
    LoadStep step;
    step.normal = {NormalControl::Kind::indentation, 5e-6};
    step.tangential[0] = {TangentialControl::Kind::shift, 1e-7};
    model->advance(step);
    step.normal.value = -5e-5;
    EXPECT_THROW(model->advance(step), contact::InputError);
    step.tangential[0].value = 0;
    EXPECT_EQ(model->advance(step).contact_area, 0);
    step.normal.value = 5e-6;
    EXPECT_GT(model->advance(step).contact_area, 0);
}

Case hysteretic(double approach) {
    Case c = sliding(.01);
    c.adhesion->approach_work = approach;
    return c;
}

// Pressed by JKR's formula of w_a, pulled as a punch of the stiffness 2 E* a as far as the edge
// opens, by that of w from there on, off at -3/2 pi w R.
TEST(AdhesiveHysteresis, IsThatOfTwoWorks) {
    constexpr double approach = .02, force = .01;
    const Case c = hysteretic(approach);
    const double modulus = c.materials().effective_modulus(), unit = pi * approach * radius;
    const auto model = mdr::make_model(c);
    const auto at = [&](double f) {
        return model->advance(pulled_along(f, {TangentialControl::Kind::force, 0}));
    };
    const auto pressed = at(force);
    const double a = std::cbrt(3 * radius / (4 * modulus) *
                               (force + 3 * unit + std::sqrt(6 * unit * force + 9 * unit * unit)));
    EXPECT_NEAR(model->scales().contact_radius / a, 1, 1e-6);
    const auto held = at(.8 * force);
    EXPECT_EQ(held.contact_area, pressed.contact_area);
    EXPECT_NEAR((pressed.normal_force - held.normal_force) /
                    (pressed.indentation - held.indentation) / (2 * modulus * a),
                1, 1e-6);
    EXPECT_EQ(held.released_energy, 0);
    // Where w opens the edge: 4/3 E* a^3/R - sqrt(8 pi E* w a^3).
    const double opens =
        4. / 3 * modulus * a * a * a / radius - std::sqrt(8 * pi * modulus * work * a * a * a);
    EXPECT_EQ(at(opens + 1e-5 * force).contact_area, pressed.contact_area);
    EXPECT_LT(at(opens - 1e-3 * force).contact_area, pressed.contact_area);
    EXPECT_NEAR(model->pull_off()->force / (1.5 * pi * work * radius), 1, 1e-6);
    at(-1.499 * pi * work * radius);
    EXPECT_THROW(at(-1.501 * pi * work * radius), contact::InputError);
    EXPECT_TRUE(model->audit().passed());
}

// What goes on from the bytes of a state is what would have gone on.
TEST(AdhesiveFriction, GoesOnFromItsState) {
    Case c = hysteretic(.02);
    c.layer.thickness = 1e-3;
    for (const bool on_layer : {false, true}) {
        const auto make = [&] { return on_layer ? mdr::make_layer_model(c) : mdr::make_model(c); };
        const auto first = make(), second = make();
        for (const double force : {.01, .004})
            first->advance(pulled_along(force, {TangentialControl::Kind::shift, 1e-6}));
        second->read_state(first->write_state());
        const auto step = pulled_along(-1e-3, {TangentialControl::Kind::shift, 2e-6});
        const auto r = first->advance(step), other = second->advance(step);
        EXPECT_EQ(r.indentation, other.indentation);
        EXPECT_EQ(r.tangential_force[0], other.tangential_force[0]);
        EXPECT_EQ(r.stored_energy, other.stored_energy);
        EXPECT_EQ(first->pull_off()->force, second->pull_off()->force);
    }
}

// A contact that has not been as wide as that of pull-off lets go at once where its edge opens.
TEST(AdhesiveHysteresis, NarrowContactsPullOffEarlier) {
    constexpr double force = 1e-4;
    const Case c = hysteretic(0);
    const double modulus = c.materials().effective_modulus();
    const auto model = mdr::make_model(c);
    model->advance(pulled_along(force, {TangentialControl::Kind::force, 0}));
    const double a = std::cbrt(3 * radius * force / (4 * modulus));
    const double opens = force - std::sqrt(8 * pi * modulus * work * a * a * a);
    EXPECT_NEAR(model->pull_off()->force / -opens, 1, 1e-5);
    EXPECT_LT(-opens, pi * work * radius);
    model->advance(pulled_along(.999 * opens, {TangentialControl::Kind::force, 0}));
    EXPECT_THROW(model->advance(pulled_along(1.001 * opens, {TangentialControl::Kind::force, 0})),
                 contact::InputError);
}

// Of a loop what the force has done is lost, in jumps and as w - w_a over the area that opens: on
// the half-space and on a layer.
TEST(AdhesiveHysteresisSlow, WorkOfALoopIsLost) {
    Case c = hysteretic(.03);
    c.load.normal_force.reset();
    c.load.indentation = 8e-6;
    c.layer.thickness = 3e-4;
    for (const bool on_layer : {false, true}) {
        const auto model = on_layer ? mdr::make_layer_model(c) : mdr::make_model(c);
        double done = 0, lost = 0;
        LoadStep step;
        step.normal = {NormalControl::Kind::indentation, 0};
        auto before = model->advance(step);
        lost += before.released_energy;
        const auto go = [&](double from, double to) {
            for (int k = 1; k <= 150; ++k) {
                step.normal.value = from + (to - from) * k / 150;
                const auto now = model->advance(step);
                if (now.contact_area > 0 || before.contact_area == 0)
                    done += (now.normal_force + before.normal_force) / 2 *
                            (now.indentation - before.indentation);
                lost += now.released_energy;
                before = now;
            }
        };
        go(0, 8e-6);
        const double last = model->pull_off()->last_indentation;
        go(8e-6, last * (1 - 1e-9));
        go(last * (1 - 1e-9), last * 1.001);
        EXPECT_EQ(before.contact_area, 0);
        EXPECT_NEAR(done / lost, 1, 2e-3) << on_layer;
        EXPECT_TRUE(model->audit().passed());
    }
}

// As w_a comes to w it is the reversible contact.
TEST(AdhesiveHysteresis, ComesToTheReversibleContact) {
    const auto hysteresis = mdr::make_model(hysteretic((1 - 1e-9) * work));
    const auto reversible = mdr::make_model(sliding(.01));
    for (const double f : {.01, .002, .006, -.001}) {
        const auto along = TangentialControl{TangentialControl::Kind::force, 0};
        const auto r = hysteresis->advance(pulled_along(f, along)),
                   other = reversible->advance(pulled_along(f, along));
        EXPECT_NEAR(r.contact_area / other.contact_area, 1, 1e-6);
        EXPECT_NEAR(r.indentation / other.indentation, 1, 1e-6);
    }
}

}  // namespace tricontact::adhesive_friction_test
