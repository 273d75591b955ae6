// Dissimilar half-spaces pressed with friction: Spence's problem. The surface is dragged inwards by
// the pressure, sticks within a radius c and slips outside; load steps show how the path matters.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "theory/friction_pressing.h"

namespace tricontact::bem_spence_test {
namespace {

using contact::Case;

struct Pressed {
    double stick_over_contact_radius;
    double stiffness_over_4_g_a;  ///< dF/dd near the end over 4 G a
};

Pressed press(double nu, double friction, int n_steps, double cells_per_radius) {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5e6, nu};
    c.friction.coefficient = friction;
    c.load.normal_force = 20;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().per_radius = cells_per_radius;
    const auto model = bem::make_model(c, 1);
    EXPECT_TRUE(model->is_coupled());
    contact::LoadStep step = contact::press_step(c);
    std::vector<contact::StepRecord> records;
    for (int k = 1; k <= n_steps; ++k) {
        step.normal.value = *c.load.normal_force * k / n_steps;
        records.push_back(model->advance(step));
    }
    EXPECT_TRUE(model->audit().passed());
    const auto &last = records.back(), &before = records[records.size() * 3 / 4];
    const double a = std::sqrt((last.contact_area + before.contact_area) / 2 / std::numbers::pi);
    const double stiffness =
        (last.normal_force - before.normal_force) / (last.indentation - before.indentation);
    return {std::sqrt(last.stick_area / last.contact_area),
            stiffness / (4 * c.substrate.shear_modulus() * a)};
}

TEST(BemSpence, StickRadiusOfWeaklyCoupledBodies) {
    const double nu = .45, beta = (1 - 2 * nu) / (2 * (1 - nu));  // .091: 1 % by its square
    for (const double beta_over_mu : {1.05, 1.4286}) {
        const double expected = theory::spence_stick_ratio(beta_over_mu);
        const double coarse = press(nu, beta / beta_over_mu, 10, 24).stick_over_contact_radius,
                     fine = press(nu, beta / beta_over_mu, 20, 24).stick_over_contact_radius;
        // First order in the step: a ring that has just come into contact starts undragged.
        EXPECT_LT(std::abs(fine - expected), std::abs(coarse - expected));
        EXPECT_NEAR(2 * fine - coarse, expected, .015);  // half a cell of 24 in a is .02
    }
}

// In one step the drag of the whole pressure acts at once: another answer, and a wrong one.
TEST(BemSpence, OneStepIsAnotherProblem) {
    const double beta = .1 / 1.1, friction = .7 * beta;
    EXPECT_LT(press(.45, friction, 1, 24).stick_over_contact_radius,
              theory::spence_stick_ratio(1 / .7) - .02);
}

TEST(BemSpence, StiffnessWithoutSlip) {
    for (const double nu : {0., .3}) {
        const double exact = theory::stuck_normal_stiffness_ratio(nu);
        // The area counts whole cells: 24 in a, 0.5 % of it; the effect is 10 and 3 %.
        EXPECT_NEAR(press(nu, 5, 16, 24).stiffness_over_4_g_a / exact, 1, .008) << nu;
    }
}

}  // namespace
}  // namespace tricontact::bem_spence_test
