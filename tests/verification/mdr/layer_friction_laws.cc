// Springs that a layer couples, or that relax, under laws of friction that are not Coulomb's: their
// bounds come from their own line loads (mdr/load_bound.h). Against mdr's springs, whose bounds
// come from the body's profile, where the layer is thick or nothing relaxes, and against boundary
// elements, whose points know the laws by themselves.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#include "mdr/settings.h"

namespace tricontact::mdr_layer_friction_laws_test {
namespace {

using std::numbers::pi;

const contact::Friction strength{.shear_strength = 3e4};
const contact::Friction power{
    .coefficient = .3, .pressure_exponent = .6, .reference_pressure = 5e4};
const contact::Friction capped{.coefficient = .5, .strength_limit = 2e4};

contact::Case sphere(const contact::Friction& friction, double w = .2) {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {2e6, .5};
    c.load.normal_force = 3;
    c.load.tangential_ratio = .3;
    c.friction = friction;
    c.contact.coupling = false;
    c.of<mdr::Settings>().springs = 20000;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->amplitude_reference = contact::Case::AmplitudeReference::model;
    c.rolling->steps = contact::Case::Steps::turning_points;
    c.rolling->periods = 300;
    return c;
}

contact::History sound_run(const contact::Case& c, contact::Model& model) {
    contact::History history = contact::run(c, model);
    EXPECT_TRUE(model.audit().passed());
    return history;
}

contact::Case on_layer(contact::Case c, double thickness) {
    c.layer.thickness = thickness;
    return c;
}

// A layer of 3000 contact radii. The edge lies anywhere between two elements of a/100, where a
// strength has a root: 0.2 h^(3/2) of it, 4e-4 of the limit at worst, twice that of shifts.
TEST(MdrLayerFrictionLaws, ThickLayersAreTheHalfSpace) {
    for (const contact::Friction& friction : {strength, power, capped}) {
        const contact::Case c = sphere(friction), thick = on_layer(c, 10);
        const auto half_space = sound_run(c, *mdr::make_model(c)),
                   layer = sound_run(thick, *mdr::make_layer_model(thick));
        const auto near = [&](double one, double other) {
            EXPECT_NEAR(one / other, 1, 8e-4) << friction.formula();
        };
        near(layer.friction_limit, half_space.friction_limit);
        near(layer.limit_tangential_ratio, half_space.limit_tangential_ratio);
        near(layer.static_shift, half_space.static_shift);
        near(layer.scales.unit_shift, half_space.scales.unit_shift);
        // Rolling adds what the edge's elements settle for.
        EXPECT_NEAR(layer.shift_per_period.back() / half_space.shift_per_period.back(), 1, 2e-3)
            << friction.formula();
    }
}

// 4 mm, 1.3 contact radii: what the layer adds to the half-space is a third. Static shifts, limits
// and F_lim agree, see docs/explanation/models/mdr-layer.md for what rolling makes of it.
TEST(MdrLayerFrictionLaws, ThinLayersAreThoseOfBoundaryElements) {
    for (const contact::Friction& friction : {strength, power}) {
        contact::Case c = on_layer(sphere(friction), 4e-3);
        c.rolling->periods = 1;
        c.of<contact::Cells>().spacing.reset();
        c.of<contact::Cells>().per_radius = 50;
        const auto line = sound_run(c, *mdr::make_layer_model(c)),
                   cells = sound_run(c, *bem::make_model(c, 1, bem::Body::layer));
        // Cells of a/50 cut the circle: 0.5 % of its area.
        EXPECT_NEAR(line.friction_limit / cells.friction_limit, 1, 5e-3) << friction.formula();
        EXPECT_NEAR(line.limit_tangential_ratio / cells.limit_tangential_ratio, 1, 2e-3)
            << friction.formula();
        EXPECT_NEAR(line.static_shift / cells.static_shift, 1, 5e-3) << friction.formula();
        EXPECT_NEAR(line.scales.unit_shift / cells.scales.unit_shift, 1, 5e-3)
            << friction.formula();
        if (!friction.shear_strength) continue;
        const double a = line.scales.contact_radius;
        EXPECT_NEAR(line.friction_limit / (*friction.shear_strength * pi * a * a), 1, 4e-4);
    }
}

// Sums of laws have sums of bounds.
TEST(MdrLayerFrictionLaws, SumsOfLawsCarryTheirSum) {
    const double mu = .2;
    contact::Friction both = strength;
    both.coefficient = mu;
    const auto limit = [](const contact::Friction& friction) {
        contact::Case c = on_layer(sphere(friction), 4e-3);
        c.rolling->periods = 1;
        const auto history = sound_run(c, *mdr::make_layer_model(c));
        return std::pair{history.friction_limit,
                         history.friction_limit * history.limit_tangential_ratio};
    };
    const auto [whole, least] = limit(both);
    const auto [of_strength, least_of_strength] = limit(strength);
    const auto [of_pressure, least_of_pressure] = limit({.coefficient = mu});
    // Of Coulomb's part the table of 256 pieces, that of the other adds up exactly.
    EXPECT_NEAR(whole / (of_strength + of_pressure), 1, 2e-5);
    EXPECT_NEAR(least / (least_of_strength + least_of_pressure), 1, 2e-5);
}

contact::Case relaxing(contact::Case c, double speed) {
    c.relaxation = contact::Relaxation{{{.8, 1.}}, contact::Relaxation::Bulk::proportional};
    c.rolling->speed = speed;
    c.rolling->steps = contact::Case::Steps::per_quarter;
    return c;
}

// Rolled so slowly that all relaxes, the bed is the elastic one; F_T acts at once, 1.8 times as
// stiff.
TEST(MdrLayerFrictionLaws, SlowRelaxingBedsAreElastic) {
    for (const contact::Friction& friction : {strength, power, capped}) {
        contact::Case c = sphere(friction);
        c.rolling->steps = contact::Case::Steps::per_quarter;
        const contact::Case slow = relaxing(c, 1e-12);
        const auto elastic = sound_run(c, *mdr::make_model(c)),
                   relaxed = sound_run(slow, *mdr::make_model(slow));
        const auto near = [&](double one, double other) {
            EXPECT_NEAR(one / other, 1, 1e-4) << friction.formula();  // 64 pieces beside 512
        };
        near(relaxed.friction_limit, elastic.friction_limit);
        near(relaxed.limit_tangential_ratio, elastic.limit_tangential_ratio);
        near(relaxed.scales.unit_shift, elastic.scales.unit_shift);
        near(1.8 * relaxed.static_shift, elastic.static_shift);
        near(relaxed.shift_per_period.back(), elastic.shift_per_period.back());
    }
}

// Rolled fast loads lean, and a cap far above all pressures is Coulomb's law, whose bound is mu
// times the load that leans.
TEST(MdrLayerFrictionLaws, RelaxingBedsHaveCoulombsLimitCase) {
    contact::Case coulomb = relaxing(sphere({.coefficient = .5}), 3e-3), other = coulomb;
    other.friction = {.coefficient = .5, .strength_limit = 1e9};
    for (contact::Case* one : {&coulomb, &other}) {
        one->of<mdr::Settings>().springs = 4000;
        one->rolling->periods = 20;
    }
    const auto of_coulomb = sound_run(coulomb, *mdr::make_model(coulomb)),
               of_other = sound_run(other, *mdr::make_model(other));
    // mu q by tables of 64 pieces, parabolas in y.
    EXPECT_NEAR(of_other.shift_per_period.back() / of_coulomb.shift_per_period.back(), 1, 1e-3);
    EXPECT_NEAR(of_other.limit_tangential_ratio / of_coulomb.limit_tangential_ratio, 1, 1e-3);
    coulomb.layer.thickness = other.layer.thickness = 4e-3;
    coulomb.rolling->periods = other.rolling->periods = 3;
    const auto layer_of_coulomb = sound_run(coulomb, *mdr::make_layer_model(coulomb, 50)),
               layer_of_other = sound_run(other, *mdr::make_layer_model(other, 50));
    EXPECT_NEAR(layer_of_other.shift_per_period.back() / layer_of_coulomb.shift_per_period.back(),
                1, 1e-3);
}

}  // namespace
}  // namespace tricontact::mdr_layer_friction_laws_test
