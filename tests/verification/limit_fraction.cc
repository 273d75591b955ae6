// load.limit_fraction: the same history as under the F_T that it stands for, found by the closed
// form of the limit, or by a run without F_T.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/own_limit.h"
#include "mdr/layer_model.h"
#include "tests/verification/bem/rig.h"
#include "tests/verification/mdr/roller.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::limit_fraction_test {
namespace {

using contact::Case;
using contact::History;

Case at_fraction(Case c, double fraction) {
    c.load.tangential_ratio.reset();
    c.load.tangential_force.reset();
    c.load.limit_fraction = fraction;
    return c;
}

double ratio(const History& h) {
    return h.tangential_force / h.friction_limit;
}

/// Shifts differ by at most `tolerance` U_max.
void expect_same(const History& a, const History& b, double tolerance) {
    const double unit = a.scales.unit_shift;
    EXPECT_NEAR(b.tangential_force / a.tangential_force, 1, tolerance);
    EXPECT_NEAR(b.static_shift / unit, a.static_shift / unit, tolerance);
    EXPECT_EQ(b.verdict.state, a.verdict.state);
    ASSERT_EQ(b.shift_per_period.size(), a.shift_per_period.size());
    for (std::size_t n = 0; n < a.shift_per_period.size(); ++n)
        EXPECT_NEAR(b.shift_per_period[n] / unit, a.shift_per_period[n] / unit, tolerance) << n;
}

History run_mdr(const Case& c) {
    const auto model = mdr::make_model(c);
    return contact::run(c, *model);
}

TEST(LimitFraction, OfMdrIsThatOfTheClosedForm) {
    for (const double w : {.1, .3, .7})
        for (const double fraction : {.2, .9, 1.1}) {
            const double f = fraction * theory::shakedown_limit(w);
            const Case c = mdr_test::sphere_rig(w, f, 10000, 3);
            const History found = run_mdr(at_fraction(c, fraction));
            EXPECT_NEAR(ratio(found), f, 1e-7) << w;
            EXPECT_NEAR(ratio(found), fraction * found.limit_tangential_ratio, 1e-12) << w;
            expect_same(run_mdr(c), found, 1e-5);
        }
}

TEST(LimitFraction, OfMdrAtADepthAndOverItsOwnRadius) {
    Case c = mdr_test::sphere_rig(.4, .6 * theory::shakedown_limit(.4), 10000, 3);
    c.load.normal_force.reset();
    c.load.indentation = .5e-3;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    const History found = run_mdr(at_fraction(c, .6));
    EXPECT_NEAR(ratio(found), .6 * found.limit_tangential_ratio, 1e-12);
    expect_same(run_mdr(c), found, 1e-5);
}

TEST(LimitFraction, OfUncoupledBemIsThatOfItsOwnPressures) {
    for (const double angle : {0., 90.}) {
        Case c = bem::rig_case(.4, 0, 20);
        c.of<contact::Cells>().spacing = 4e-4;
        c.rolling->angle = angle * std::numbers::pi / 180;
        const History found = bem::run_bem(at_fraction(c, .7));
        EXPECT_NEAR(ratio(found), .7 * found.limit_tangential_ratio, 1e-6);
        // 11 cells in the contact radius.
        EXPECT_NEAR(ratio(found), .7 * theory::shakedown_limit(.4), 4e-3);
        EXPECT_EQ(found.verdict.state, contact::State::shakedown);
        c.load.tangential_ratio = ratio(found);
        expect_same(bem::run_bem(c), found, 1e-6);
        EXPECT_EQ(bem::run_bem(at_fraction(c, 1.02)).verdict.state, contact::State::ratcheting);
    }
}

Case layer_case(double w) {
    Case c = bem::rig_case(w, 0, 12);
    c.indenter.material.reset();
    c.layer.thickness = 8e-3;
    c.of<contact::Cells>().spacing = 4e-4;
    return c;
}

History run_layer(const Case& c) {
    const auto model = bem::make_model(c, 1, bem::Body::layer);
    EXPECT_TRUE(model->is_coupled());
    return contact::run(c, *model);
}

TEST(LimitFraction, OfACoupledLayerIsThatOfFrictionlessPressures) {
    for (const bool at_depth : {false, true}) {
        Case c = layer_case(.3);
        if (at_depth) {
            c.load.normal_force.reset();
            c.load.indentation = .3e-3;
        }
        // Without friction all is uncoupled.
        Case uncoupled = c;
        uncoupled.contact.coupling = false;
        const auto model = bem::make_model(uncoupled, 1, bem::Body::layer);
        const double limit = contact::frictionless_limit(uncoupled, *model).tangential_ratio;
        const History found = run_layer(at_fraction(c, .5));
        EXPECT_NEAR(ratio(found), .5 * limit, 1e-6);
        // What friction does to the pressures of this layer.
        EXPECT_NEAR(found.limit_tangential_ratio, limit, 2e-2);
        EXPECT_NE(found.limit_tangential_ratio, limit);
        c.load.tangential_ratio = .5 * limit;
        expect_same(run_layer(c), found, 1e-5);
    }
}

TEST(LimitFraction, OfMdrLayer) {
    Case c = layer_case(.3);
    const auto run = [](const Case& at) {
        const auto model = mdr::make_layer_model(at);
        return contact::run(at, *model);
    };
    const History found = run(at_fraction(c, .5));
    EXPECT_NEAR(ratio(found), .5 * found.limit_tangential_ratio, 1e-6);
    c.load.tangential_ratio = ratio(found);
    expect_same(run(c), found, 1e-6);
}

TEST(LimitFraction, IsRefusedWhereTheContactSlidesOrNothingHolds) {
    const Case c = mdr_test::sphere_rig(.2, 0, 1000, 3);
    EXPECT_THROW(run_mdr(at_fraction(c, 1.5)), contact::InputError);
    Case far = c;
    far.rolling->amplitude_ratio = 1.2;
    try {
        run_mdr(at_fraction(far, .5));
        FAIL() << "nothing holds the indenter";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("leaves no point in contact"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace tricontact::limit_fraction_test
