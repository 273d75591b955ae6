// Springs that a tension of some range stretches: Maugis' closed form, energy around a loop, where
// bodies meet that attract each other over a distance.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "mdr/model.h"
#include "tests/unit/adhesive_ball.h"
#include "theory/adhesive/adhesive_curve.h"
#include "theory/adhesive/maugis_dugdale.h"

namespace tricontact::adhesive_range_test {

using std::numbers::pi;
using test::AdhesiveBall;

// Under depths and forces, pressing and pulling; 10000 springs leave 1e-8. Largest lambda: almost
// Johnson, Kendall and Roberts; least: Derjaguin, Muller and Toporov.
TEST(AdhesiveRange, IsMaugisSolution) {
    for (const double lambda : {.02, .1, .5, 1., 3., 10.}) {
        const AdhesiveBall ball(lambda);
        const auto model = mdr::make_model(ball.c);
        for (const double depth : {2., 1., .2}) {
            const auto record = ball.press(*model, depth);
            const auto exact = theory::maugis_contact_at(lambda, depth);
            EXPECT_NEAR(record.normal_force / ball.force(), exact.force, 1e-6) << lambda;
            EXPECT_NEAR(model->scales().contact_radius / ball.radius(), exact.radius, 1e-6);
        }
        const auto pulled = theory::maugis_pull_off(lambda);
        const auto off = model->pull_off().value();
        EXPECT_NEAR(off.force / ball.force(), -pulled.force, 1e-6) << lambda;
        if (lambda >= .5) {
            EXPECT_NEAR(off.radius / ball.radius(), pulled.radius, 1e-3);  // F is flat there
            EXPECT_NEAR(off.indentation / ball.depth(), pulled.indentation, 1e-3);
        }
        contact::LoadStep step;
        step.normal = {contact::NormalControl::Kind::force, .9 * pulled.force * ball.force()};
        model->advance(step);
        EXPECT_NEAR(model->scales().contact_radius / ball.radius(),
                    theory::maugis_contact_under(lambda, .9 * pulled.force).radius, 1e-6);
        step.normal.value = 1.01 * pulled.force * ball.force();
        EXPECT_THROW(model->advance(step), contact::InputError);
        EXPECT_TRUE(model->audit().passed());
    }
}

// From far apart to contact and back, of a range at which it jumps in and off, and of one at which
// it hardly does. F is the slope of what is stored, so that a smooth way back costs nothing, and
// the work around the loop, without the steps that jump, is what the jumps lose.
TEST(AdhesiveRange, LosesTheEnergyOfItsJumpsAlone) {
    double lost_by_short_range = 0;
    for (const double lambda : {1., .1}) {
        const AdhesiveBall ball(lambda, 1);
        const auto model = mdr::make_model(ball.c);
        const double range = ball.c.adhesion->distance() / ball.depth(), first = -range - .5;
        double work = 0, lost = 0;
        int jumps = 0, differ = 0;
        auto before = ball.press(*model, first);
        EXPECT_EQ(before.normal_force, 0);
        const auto go = [&](double to) {
            constexpr int n = 400;
            const double from = before.indentation / ball.depth();
            for (int k = 1; k <= n; ++k) {
                const auto now = ball.press(*model, from + (to - from) * k / n);
                lost += now.released_energy;
                jumps += now.released_energy > 1e-3 * ball.force() * ball.depth();
                differ += now.may_differ;
                work += .5 * (now.normal_force + before.normal_force) *
                        (now.indentation - before.indentation);
                before = now;
            }
        };
        go(1);
        EXPECT_NEAR(before.normal_force / ball.force(), theory::maugis_contact_at(lambda, 1).force,
                    1e-6);
        go(first);
        EXPECT_EQ(before.normal_force, 0);
        EXPECT_TRUE(model->audit().passed());
        if (lambda == 1) {
            lost_by_short_range = lost;
            EXPECT_EQ(jumps, 2);
            EXPECT_GT(differ, 10);
            // The trapezoids do not see where in a step it jumps, by a force of up to 1.5.
            EXPECT_NEAR(work / lost, 1, .03);
        } else {
            EXPECT_LT(lost, .02 * lost_by_short_range);
        }
    }
}

// Hardly deformed bodies that do not touch: F = -pi c^2 sigma_0 with c^2 = 2 R (d + delta), what
// Derjaguin's approximation has.
TEST(AdhesiveRange, AttractsBeforeTheTouch) {
    const AdhesiveBall ball(.01, 1);
    const auto model = mdr::make_model(ball.c);
    const double range = ball.c.adhesion->distance(), d = -.5 * range;
    const auto record = ball.press(*model, d / ball.depth());
    EXPECT_EQ(record.contact_area, 0);
    const double exact = -2 * pi * ball.R * (d + range) * ball.c.adhesion->strength();
    EXPECT_NEAR(record.normal_force / exact, 1, .01);
    const auto s = model->surface();
    double force = 0;
    for (const double q : s.normal_line_load) force += q * s.spacing[0];
    EXPECT_NEAR(force / record.normal_force, 1, .02);
}

// Any body of revolution: a cone comes to its pull-off without a range, 54 w^2/(pi t^3 E*) (Maugis
// and Barquins 1981), as the tension grows.
TEST(AdhesiveRange, OfAConeComesToNoRange) {
    AdhesiveBall ball(0, 1);
    ball.c.indenter.shape = contact::Case::Shape::cone;
    ball.c.indenter.radius = 0;
    ball.c.indenter.angle = 5 * pi / 180;
    const double modulus = ball.c.materials().effective_modulus(),
                 t = std::tan(ball.c.indenter.angle),
                 exact = 54 * ball.w * ball.w / (pi * t * t * t * modulus);
    ball.c.load.indentation = 20 * ball.w / (modulus * t * t);
    double last = 1;
    for (const double strength : {2., 8.}) {
        ball.c.adhesion->peak_stress = strength * modulus * t;
        const auto model = mdr::make_model(ball.c);
        // A tip as steep as this is attracted without a jump.
        const double range = ball.c.adhesion->distance() / ball.depth();
        EXPECT_LT(ball.press(*model, -.5 * range).normal_force, 0);
        EXPECT_GT(ball.press(*model, ball.c.load.indentation.value() / ball.depth()).normal_force,
                  0);
        const double off = model->pull_off()->last_indentation / ball.depth();
        EXPECT_GT(ball.press(*model, off + 1e-3 * range).contact_area, 0);
        EXPECT_EQ(ball.press(*model, off - 1e-3 * range).contact_area, 0);
        EXPECT_EQ(ball.press(*model, off - 1.01 * range).normal_force, 0);
        EXPECT_TRUE(model->audit().passed());
        const double error = model->pull_off()->force / exact - 1;
        EXPECT_LT(std::abs(error), .5 * last);
        last = std::abs(error);
    }
    EXPECT_LT(last, .02);
}

}  // namespace tricontact::adhesive_range_test
