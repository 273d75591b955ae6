// Springs under laws of friction that are not Coulomb's, against the closed forms of theory/ (shear
// strength: derived there, and values of another simulation by springs) and against Coulomb's law
// in their limit cases.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/case.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"

namespace tricontact::mdr_friction_laws_test {
namespace {

using std::numbers::pi;

contact::Case sphere(const contact::Friction& friction, double w = 0, double f = .3) {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {2e6, .5};
    c.load.normal_force = 3;
    c.load.tangential_ratio = f;
    c.friction = friction;
    c.of<mdr::Settings>().springs = 20000;
    if (w == 0) return c;
    c.rolling = contact::Case::Rolling{};
    c.rolling->amplitude_ratio = w;
    c.rolling->periods = 2000;
    c.rolling->steps = contact::Case::Steps::turning_points;
    return c;
}

contact::History run(const contact::Case& c) {
    const auto model = mdr::make_model(c);
    contact::History history = contact::run(c, *model);
    EXPECT_TRUE(model->audit().passed());
    return history;
}

double strength_force(double u) {
    return 2 / pi * (u * std::sqrt(1 - u * u) + std::asin(u));
}

/// u = U G*/(2 tau_0 a) of the contact's own a.
double reduced(const contact::Case& c, const contact::History& h, double shift) {
    return shift * c.materials().effective_shear_modulus() /
           (2 * *c.friction.shear_strength * h.scales.contact_radius);
}

// Whole springs: the discs' edges are off by dx^2, the kinks of the bounds by dx^2/12; 1e-4 a here.
constexpr double tolerance = 1e-6;

TEST(MdrFrictionLaws, ShearStrengthHoldsAsItsClosedForm) {
    for (const double f : {.1, .3, .55, .9}) {
        const contact::Case c = sphere({.shear_strength = 3e5}, 0, f);
        const contact::History h = run(c);
        const double a = h.scales.contact_radius;
        EXPECT_NEAR(h.friction_limit / (3e5 * pi * a * a), 1, tolerance);
        EXPECT_NEAR(strength_force(reduced(c, h, h.static_shift)), f, tolerance) << f;
        EXPECT_NEAR(reduced(c, h, h.scales.unit_shift), 1, tolerance);
    }
}

// Masing's rule: unloading by dF shifts back by twice what dF/2 shifts from rest.
TEST(MdrFrictionLaws, UnloadsByMasingsRule) {
    const contact::Case c = sphere({.shear_strength = 3e5});
    const auto model = mdr::make_model(c);
    contact::LoadStep step;
    step.normal.value = 3;
    model->advance(step);
    const double limit = model->scales().sliding_force, a = model->scales().contact_radius;
    const auto shift_at = [&](double f) {
        step.tangential[0].value = f * limit;
        return model->advance(step).shift[0] * c.materials().effective_shear_modulus() /
               (2 * 3e5 * a);
    };
    const double up = shift_at(.8), down = shift_at(-.2), again = shift_at(.5);
    EXPECT_NEAR(strength_force(up), .8, tolerance);
    EXPECT_NEAR(2 * strength_force((up - down) / 2), 1., tolerance);
    EXPECT_NEAR(2 * strength_force((again - down) / 2), .7, tolerance);
}

TEST(MdrFrictionLaws, ShearStrengthShakesDownWhereTheClosedFormSays) {
    struct {
        double w, f, settled, limit;
    } const table[] = {{.2, .3, .30024, .74706},
                       {.2, .55, .58386, .74706},
                       {.4, .2, .26715, .50463},
                       {.4, .35, .49270, .50463}};
    for (const auto& [w, f, settled, limit] : table) {
        const contact::Case c = sphere({.shear_strength = 3e5}, w, f);
        const contact::History h = run(c);
        EXPECT_EQ(h.verdict.state, contact::State::shakedown);
        const double u = reduced(c, h, h.shift_per_period.back());
        // Both to five digits; the run ends where the rest is estimated below its accuracy.
        EXPECT_NEAR(u, settled, 2e-5) << w << ' ' << f;
        EXPECT_NEAR(h.limit_tangential_ratio, limit, 6e-6);
        EXPECT_NEAR(h.limit_tangential_ratio, 2 / pi * (std::acos(w) - w * std::sqrt(1 - w * w)),
                    2 * tolerance);
    }
}

TEST(MdrFrictionLaws, RatchetsAboveTheLimit) {
    contact::Case c = sphere({.shear_strength = 3e5}, .4, .51);
    c.rolling->periods = 60;
    EXPECT_EQ(run(c).verdict.state, contact::State::ratcheting);
}

// Each law where it must be Coulomb's: shifts of the same springs.
TEST(MdrFrictionLaws, EveryLimitCaseIsCoulombs) {
    const double coulomb = run(sphere({.coefficient = .5}, .2, .4)).shift_per_period.back();
    const contact::Friction near[] = {
        {.coefficient = .5, .shear_strength = 1e-3},
        {.coefficient = .5, .pressure_exponent = 1 - 1e-9, .reference_pressure = 1e5},
        {.coefficient = .5, .strength_limit = 1e9}};
    for (const contact::Friction& friction : near)
        EXPECT_NEAR(run(sphere(friction, .2, .4)).shift_per_period.back() / coulomb, 1, 1e-5)
            << friction.formula();
    // A coefficient below any pressure's use: the strength alone.
    const double strength = run(sphere({.shear_strength = 3e5}, .2, .4)).shift_per_period.back();
    EXPECT_NEAR(
        run(sphere({.coefficient = 1e-9, .shear_strength = 3e5}, .2, .4)).shift_per_period.back() /
            strength,
        1, 1e-6);
}

// The cap of Orowan's law far below the pressure is a strength where mu p has passed it: all but a
// ring at the edge, of the relative width (tau_cap/(mu p0))^2/2.
TEST(MdrFrictionLaws, ALowCapIsAShearStrength) {
    const double cap = 1e3;
    const contact::History capped = run(sphere({.coefficient = .9, .strength_limit = cap}, 0, .5));
    const contact::History strength = run(sphere({.shear_strength = cap}, 0, .5));
    const double edge = cap / (.9 * strength.scales.peak_pressure);
    EXPECT_LT(edge, .02);
    EXPECT_NEAR(capped.friction_limit / strength.friction_limit, 1, edge * edge);
    EXPECT_LT(capped.friction_limit, strength.friction_limit);
    EXPECT_NEAR(capped.static_shift / strength.static_shift, 1, 2 * edge * edge);
}

}  // namespace
}  // namespace tricontact::mdr_friction_laws_test
