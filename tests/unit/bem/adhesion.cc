// Surfaces that attract each other, on the half-space: Johnson, Kendall and Roberts, Maugis,
// Derjaguin.

#include "theory/adhesion.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/larger_grids.h"
#include "contact/run.h"
#include "tests/unit/adhesive_ball.h"
#include "theory/adhesive/adhesive_curve.h"
#include "theory/adhesive/adhesive_layer.h"
#include "theory/adhesive/maugis_dugdale.h"

namespace tricontact::bem_adhesion_test {
namespace {

using contact::Adhesion;
using contact::NormalControl;
using std::numbers::pi;

struct Ball : test::AdhesiveBall {
    /// Cells per unit of the radius.
    Ball(double lambda, double cells, double deepest = 2) : AdhesiveBall(lambda, deepest) {
        c.of<contact::Cells>().spacing = radius() / cells;
    }
};

contact::StepRecord at(contact::Model& model, const Ball& ball, double depth) {
    return ball.press(model, depth);
}

/// On the outer branch, whose depth rises with the radius.
theory::MaugisContact maugis_at(double lambda, double depth) {
    double low = .8, high = 5;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (theory::maugis_contact(lambda, middle).indentation < depth ? low : high) = middle;
    }
    return theory::maugis_contact(lambda, low);
}

// Errors of the force over pi w R; the edge of the tension is a straight line within a cell, what
// is left falls with the cells.
TEST(BemAdhesionSlow, ForcesOfMaugisTransition) {
    struct Row {
        double lambda, cells, allowed;
    };
    for (const auto& [lambda, cells, allowed] :
         {Row{.1, 10, 1e-3}, Row{.5, 10, 2.5e-3}, Row{.5, 20, 1e-3}, Row{1, 20, 3e-3},
          Row{1, 40, 1e-3}}) {
        const Ball ball(lambda, cells);
        const auto model = bem::make_model(ball.c, 1);
        for (const double depth : {2., 1.}) {
            const auto record = at(*model, ball, depth);
            const auto exact = maugis_at(lambda, depth);
            EXPECT_NEAR(record.normal_force / ball.force(), exact.force, allowed) << lambda;
            EXPECT_NEAR(std::sqrt(record.contact_area / pi) / ball.radius(), exact.radius,
                        .3 / cells)
                << lambda;
        }
        EXPECT_TRUE(model->audit().passed());
    }
}

// The other end of the transition: hardly deformed, the force as they meet is that of Derjaguin,
// Muller and Toporov, -2 pi w R, but for what lambda leaves of it.
TEST(BemAdhesion, HoldsAsBodiesThatTheTensionDoesNotDeform) {
    double last = .2;
    for (const double lambda : {.02, .005}) {
        const Ball ball(lambda, 3, .3);
        const auto model = bem::make_model(ball.c, 1);
        const double force = at(*model, ball, 0).normal_force / ball.force();
        EXPECT_NEAR(force, theory::maugis_contact_at(lambda, 0).force, 5e-3);
        EXPECT_LT(force + 2, .6 * last);
        last = force + 2;
    }
    EXPECT_LT(last, .05);
}

// Short-ranged: the tension acts over three cells, an error of the first order.
TEST(BemAdhesion, ApproachesJohnsonKendallAndRoberts) {
    double last = 0;
    for (const double cells : {5., 10., 20.}) {
        const Ball ball(0, cells);
        const auto model = bem::make_model(ball.c, 1);
        // P = A^3 - A (6 A)^(1/2), D = A^2 - 2/3 (6 A)^(1/2)
        const double a = 2.08797, exact = a * a * a - a * std::sqrt(6 * a);
        const auto record = at(*model, ball, a * a - 2. / 3 * std::sqrt(6 * a));
        const double error = std::abs(record.normal_force / ball.force() - exact);
        EXPECT_LT(error, .35 / cells);
        EXPECT_NEAR(std::sqrt(record.contact_area / pi) / ball.radius(), a, .03 / cells * 5);
        if (last > 0) {
            EXPECT_LT(error, .75 * last);
        }
        last = error;
    }
}

// Pressed and pulled off: the work of the force is what the jumps set free, the loop passes through
// the same states where nothing jumps, and the largest tension is JKR's but for the cells.
TEST(BemAdhesion, LosesTheEnergyOfItsJumpsAlone) {
    const Ball ball(0, 6, 1);
    const auto model = bem::make_model(ball.c, 1);
    constexpr double step = .05;
    constexpr int n = 50;
    double work = 0, released = 0, jumps = 0, last_jump = 0;
    int n_differ = 0;
    std::vector<double> loading, unloading;
    contact::StepRecord before = at(*model, ball, -1.5);
    const auto go = [&](double depth, std::vector<double>& forces) {
        const auto now = at(*model, ball, depth);
        work +=
            .5 * (now.normal_force + before.normal_force) * (now.indentation - before.indentation);
        released += now.released_energy;
        jumps += now.released_energy > .05 * ball.force() * ball.depth() ? now.released_energy : 0;
        n_differ += now.may_differ;
        if (now.contact_area == 0 && before.contact_area > 0) last_jump = now.released_energy;
        forces.push_back(now.normal_force / ball.force());
        before = now;
    };
    for (int k = 1; k <= n; ++k) go(-1.5 + k * step, loading);
    for (int k = n - 1; k >= 0; --k) go(-1.5 + k * step, unloading);
    const double unit = ball.force() * ball.depth();
    EXPECT_EQ(before.normal_force, 0);
    for (int k = 0; k < 30; ++k) EXPECT_NEAR(unloading[k], loading[n - 2 - k], 1e-4) << k;
    // The trapezoids do not see where in a step it jumps, by a force of up to 1.4.
    EXPECT_NEAR(work / unit, released / unit, 1.4 * step);
    EXPECT_GT(released, .1 * unit);
    // Smooth steps lose nothing: energies are those whose slope is the force.
    EXPECT_NEAR(jumps / released, 1, 1e-3);
    // Where the tension of three cells brings bodies together they are not apart any more: on the
    // way there and on that back as many states have another one beside them.
    EXPECT_GT(n_differ, 2);
    EXPECT_EQ(n_differ % 2, 0);
    const auto body = ball.c.make_axisymmetric_indenter();
    theory::AdhesiveCurve exact =
        theory::half_space_curve(*body, ball.c.materials().effective_modulus(), ball.w);
    const auto motion = exact.follow(exact.at(2 * ball.radius()),
                                     {NormalControl::Kind::indentation, -1.5 * ball.depth()});
    EXPECT_FALSE(motion.state.touches());
    // At the end the tension acts over half of the contact: 0.82 at 6 cells per unit.
    EXPECT_NEAR(last_jump / motion.released, 1, .25);
    const auto off = model->pull_off();
    ASSERT_TRUE(off);
    EXPECT_NEAR(off->force / ball.force(), 1.5, .03);
    EXPECT_NEAR(off->radius / ball.radius(), std::cbrt(1.5), .12);
    // A run that goes on from what was kept finds the same.
    const auto resumed = bem::make_model(ball.c, 1);
    resumed->read_state(model->write_state());
    EXPECT_EQ(resumed->pull_off().value().force, off->force);
    EXPECT_LT(off->last_indentation, off->indentation);
    EXPECT_GT(off->last_indentation, -1.5 * ball.depth());
}

// Against the integral equation of the layer, from thick to thin ones: the contact under a force,
// and the pull-off, whose error falls with the cells; a thin layer needs ten across its thickness.
TEST(BemAdhesionSlow, OfALayerAsItsExactTheory) {
    for (const auto& [thickness, nu] : {std::pair{1., .3}, {1., .49}, {.3, .5}}) {
        Ball ball(0, 10);
        ball.c.substrate = {1e6, nu};
        const double a_off = std::cbrt(1.5) * ball.radius();
        ball.c.layer.thickness = thickness * a_off;
        ball.c.load.indentation.reset();
        const NormalControl press{NormalControl::Kind::force, 3 * ball.force()};
        ball.c.load.normal_force = press.value;
        const auto body = ball.c.make_axisymmetric_indenter();
        auto exact = theory::layer_curve({ball.c.substrate, thickness * a_off}, *body, ball.w);
        const auto pressed = exact.follow({}, press).state;
        double last = 0;
        for (const double cells : thickness == 1 ? std::array{8., 16.} : std::array{16., 32.}) {
            ball.c.of<contact::Cells>().spacing = a_off / cells;
            const auto model = bem::make_model(ball.c, 1, bem::Body::layer);
            contact::LoadStep step;
            step.normal = press;
            const auto record = model->advance(step);
            EXPECT_NEAR(std::sqrt(record.contact_area / pi) / pressed.radius, 1, 5e-3);
            EXPECT_NEAR(record.indentation / pressed.indentation, 1, 6e-3);
            const auto off = model->pull_off();
            ASSERT_TRUE(off);
            const double error = std::abs(off->force / exact.pull_off().force - 1);
            EXPECT_NEAR(off->radius / exact.pull_off().radius, 1, 1 / cells);  // F is flat there
            if (last > 0) {
                EXPECT_LT(error, .75 * last);
            }
            last = error;
        }
        EXPECT_LT(last, 1e-2);
    }
}

// Apart, and stiff: Derjaguin's approximation is exact for a paraboloid, F = -2 pi R w
// exp(d/range).
TEST(BemAdhesion, ExponentialTensionOfStiffBodiesApart) {
    Ball ball(.01, 3, .2);
    ball.c.adhesion->law = Adhesion::Law::exponential;
    const auto model = bem::make_model(ball.c, 1);
    const double range = ball.c.adhesion->distance();
    contact::LoadStep step;
    step.normal = {NormalControl::Kind::indentation, -.5 * range};
    const auto record = contact::on_large_enough_grid(*model, [&] { return model->advance(step); });
    EXPECT_NEAR(record.normal_force / (-2 * pi * ball.R * ball.w * std::exp(-.5)), 1, 2e-2);
    EXPECT_EQ(record.contact_area, 0);
}

TEST(BemAdhesion, RefusesWhatItCannotDo) {
    const Ball coarse(3, 5);
    EXPECT_THROW(bem::make_model(coarse.c, 1), contact::InputError);
    const Ball ball(.5, 5);
    const auto model = bem::make_model(ball.c, 1);
    at(*model, ball, 1);
    contact::LoadStep step;
    step.normal = {NormalControl::Kind::force, -1.5 * ball.force()};
    EXPECT_NEAR(model->advance(step).normal_force / ball.force(), -1.5, 1e-8);
    step.normal.value = -1.9 * ball.force();
    EXPECT_THROW(model->advance(step), contact::InputError);
}

}  // namespace
}  // namespace tricontact::bem_adhesion_test
