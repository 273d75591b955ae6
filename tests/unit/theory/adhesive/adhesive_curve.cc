// Short-ranged adhesion on the half-space by the formulas of Johnson, Kendall and Roberts, on
// layers by their closed limits, and energy on both.

#include "theory/adhesive/adhesive_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/bodies/indenter.h"
#include "contact/bodies/shapes_of_revolution.h"
#include "theory/adhesive/adhesive_layer.h"

namespace tricontact::adhesive_curve_test {

using contact::NormalControl;
using std::numbers::pi;
using theory::AdhesiveCurve, theory::half_space_curve, theory::layer_curve,
    theory::thin_incompressible_layer;

constexpr double modulus = 2.4e6, work = .07, radius = 4e-3;
constexpr double rounding = 1e-10;

NormalControl depth(double value) {
    return {NormalControl::Kind::indentation, value};
}
NormalControl force(double value) {
    return {NormalControl::Kind::force, value};
}

// F = 4 E* a^3/(3 R) - sqrt(8 pi E* w a^3), d = a^2/R - sqrt(2 pi a w/E*).
TEST(AdhesiveCurve, OfAParaboloidIsThatOfJohnsonKendallAndRoberts) {
    const contact::Paraboloid body(radius);
    const auto curve = half_space_curve(body, modulus, work);
    for (const double a : {2e-5, 1e-4, 4e-4}) {
        const auto s = curve.at(a);
        const double pressed = 4 * modulus * std::pow(a, 3) / (3 * radius);
        EXPECT_NEAR(s.force, pressed - std::sqrt(8 * pi * modulus * work * std::pow(a, 3)),
                    rounding * pressed);
        EXPECT_NEAR(s.indentation, a * a / radius - std::sqrt(2 * pi * a * work / modulus),
                    rounding * a * a / radius);
    }
}

// -3/2 pi w R at a^3 = 9 pi w R^2/(8 E*); under depth -5/6 pi w R there, the last depth being
// -3/4 (pi^2 w^2 R/E*^2)^(1/3) (Maugis 2000, 4.3; Johnson 1985, 5.5).
TEST(AdhesiveCurve, PullOffIsTheClosedOne) {
    const contact::Paraboloid body(radius);
    auto curve = half_space_curve(body, modulus, work);
    const auto off = curve.pull_off();
    EXPECT_NEAR(off.force / (1.5 * pi * work * radius), 1, rounding);
    EXPECT_NEAR(off.radius / std::cbrt(9 * pi * work * radius * radius / (8 * modulus)), 1, 1e-6);
    const double unit = std::cbrt(std::pow(pi * work / modulus, 2) * radius);
    EXPECT_NEAR(off.last_indentation / (-.75 * unit), 1, rounding);
}

// A loop under depth: touch at 0, in, out beyond the last depth. Work is what both jumps lose, the
// work by the trapezoidal rule over nodes 1.5 % apart.
TEST(AdhesiveCurve, WorkOfALoopIsLostInItsJumps) {
    const contact::Paraboloid body(radius);
    auto curve = half_space_curve(body, modulus, work);
    AdhesiveCurve::State s;
    double done = 0, lost = 0;
    int jumps = 0;
    for (const double d : {-1e-5, 1e-6, 3e-5, -2e-6, -3e-5}) {
        const auto m = curve.follow(s, depth(d));
        s = m.state;
        done += m.work;
        lost += m.released;
        jumps += m.jumps;
    }
    EXPECT_FALSE(s.touches());
    EXPECT_EQ(jumps, 2);
    EXPECT_NEAR(done / lost, 1, 1e-3);
}

// Where nothing jumps the way back is the way there, and its work is what is stored.
TEST(AdhesiveCurve, SmoothMotionReverses) {
    const contact::Paraboloid body(radius);
    auto curve = half_space_curve(body, modulus, work);
    const auto pressed = curve.follow({}, force(5e-3)).state;
    const auto there = curve.follow(pressed, force(-1e-3)),
               back = curve.follow(there.state, force(5e-3));
    EXPECT_NEAR(back.state.radius / pressed.radius, 1, rounding);
    EXPECT_EQ(there.jumps + back.jumps, 0);
    const double stored = curve.stored(pressed) - curve.stored(there.state);
    EXPECT_NEAR(-there.work / stored, 1, 1e-3);
    EXPECT_THROW(curve.follow(pressed, force(-1.51 * pi * work * radius)), contact::InputError);
}

// A flat punch holds sqrt(8 pi a^3 E* w) (Maugis and Barquins 1978): the force of the detachment l.
TEST(AdhesiveCurve, PunchHoldsAsThatOfMaugisAndBarquins) {
    const contact::Paraboloid body(radius);
    const auto curve = half_space_curve(body, modulus, work);
    const double a = 1e-4;
    const double force = 2 * modulus * a * curve.at(a).detached;
    EXPECT_NEAR(force / std::sqrt(8 * pi * modulus * work * std::pow(a, 3)), 1, rounding);
}

// Rounded ever more sharply a punch comes to hold that, from above: the contact climbs its
// rounding.
TEST(AdhesiveCurve, OfARoundedPunchComesToThatOfMaugisAndBarquins) {
    const double flat = 2e-3, punch = std::sqrt(8 * pi * modulus * work * std::pow(flat, 3));
    const auto above = [&](double rounding_radius) {
        const contact::RoundedPunch body(flat, rounding_radius);
        return half_space_curve(body, modulus, work).pull_off().force / punch - 1;
    };
    EXPECT_GT(above(1), 2 * above(.1));
    EXPECT_GT(above(.1), 2 * above(.01));
    EXPECT_GT(above(.01), 0);
    // The kink at the flat's edge is found to the step by which the least force is sought, 1e-5.
    EXPECT_NEAR(above(1e-5), 0, 2e-5);
}

// A cone of the slope t = tan(beta): d = pi/2 a t - l, F = pi/2 E* t a^2 - 2 E* a l, so that it
// pulls off at 54 w^2/(pi t^3 E*) (Maugis and Barquins 1981).
TEST(AdhesiveCurve, OfAConePullsOffAsThatOfMaugisAndBarquins) {
    class Cone final : public contact::AxisymmetricIndenter {
      public:
        double profile(double r) const override { return .1 * r; }
        double profile_slope(double) const override { return .1; }
    } const body;
    auto curve = half_space_curve(body, modulus, work);
    EXPECT_NEAR(curve.pull_off().force / (54 * work * work / (pi * 1e-3 * modulus)), 1, 1e-8);
}

theory::ElasticLayer layer(double nu, double thickness, theory::LayerBase base) {
    return {contact::Material{modulus * (1 - nu * nu), nu}, thickness, base};
}

// Energy: dS/da = 2 E* e^2 joins stiffness and edge of the integral equation, which do not know of
// each other. Central differences of 1e-4: 1e-8 of curvature.
TEST(AdhesiveLayer, StiffnessAndEdgeHaveOneEnergy) {
    const contact::Paraboloid body(radius);
    for (const auto base : {theory::LayerBase::bonded, theory::LayerBase::frictionless})
        for (const double nu : {.3, .5}) {
            const auto curve = layer_curve(layer(nu, 1e-4, base), body, work);
            const double a = 2e-4, h = 1e-4 * a;
            const auto punch = [&](double at) {  // dU of a small pull at a fixed radius
                return curve.at(at);
            };
            // On a curve dF/da - S dd/da = -S' l with S = dF/dl at fixed a; by energy the work
            // F dd is d(U - w A).
            const auto low = punch(a - h), high = punch(a + h), here = punch(a);
            const double stored = curve.stored(high) - curve.stored(low);
            const double done = here.force * (high.indentation - low.indentation);
            EXPECT_NEAR(done / stored, 1, 1e-6) << nu;
        }
}

TEST(AdhesiveLayer, ThickIsTheHalfSpace) {
    const contact::Paraboloid body(radius);
    auto curve = layer_curve(layer(.3, 1, theory::LayerBase::bonded), body, work);
    const auto s = curve.at(1e-3);
    const auto same = half_space_curve(body, modulus, work).at(1e-3);
    EXPECT_NEAR(s.force / same.force, 1, 2e-3);  // O(a/b)
    EXPECT_NEAR(s.indentation / same.indentation, 1, 2e-3);
}

// Thin layers: F(a) by the closed limits, with errors of O(b/a).
TEST(AdhesiveLayer, ThinIsAFoundationOrAFlow) {
    const contact::Paraboloid body(1);
    double before = 1;
    for (const double a_over_b : {8., 24.}) {
        const double b = 1e-3, a = a_over_b * b;
        const auto elastic = layer(.5, b, theory::LayerBase::bonded);
        const auto s = layer_curve(elastic, body, work).at(a);
        const auto thin = thin_incompressible_layer(elastic, 1, work, a);
        const double error = std::abs(s.indentation / thin.indentation - 1);
        EXPECT_LT(error, 4 / a_over_b);
        EXPECT_LT(error, before / 2);
        before = error;
    }
}

// 3/2 pi w R on a thick layer, 2 pi w R on a thin one that can be compressed, 3 pi w R on a thin
// incompressible one.
TEST(AdhesiveLayer, PullOffGrowsFromThickToThin) {
    const auto force_over = [&](double nu, double thickness) {
        const contact::Paraboloid body(1);
        auto curve = layer_curve(layer(nu, thickness, theory::LayerBase::bonded), body, work);
        return curve.pull_off().force / (pi * work);
    };
    const double unit = std::cbrt(work / modulus);  // of the contact under R = 1 m
    EXPECT_NEAR(force_over(.3, 100 * unit), 1.5, .02);
    EXPECT_NEAR(force_over(.3, unit / 20), 2, .06);
    // Of O(b/a), a of the root of b: a quarter of the thickness has half the error.
    const double first = 3 - force_over(.5, unit / 20), second = 3 - force_over(.5, unit / 80);
    EXPECT_NEAR(second / first, .5, .07);
    EXPECT_LT(second, .2);
}

}  // namespace tricontact::adhesive_curve_test
