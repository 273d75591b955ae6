// Rolling under an oscillating F_T: does friction work for good? By definition of the verdicts it
// is cyclic slip if it does. The steps decide: work that is their own vanishes with them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/cells.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "tests/verification/bem/rig.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::bem::bem_oscillating_force_test {
namespace {

using contact::Case;
using contact::History;
using contact::State;

/// f_T oscillates by `part` of its mean.
Case oscillating(double w, int steps_per_quarter, double mean = .3, double part = .4) {
    Case c = rig_case(w, mean, 30);
    c.rolling->steps = Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = steps_per_quarter;
    c.load.tangential_amplitude_ratio = part;
    c.load.tangential_phase = std::numbers::pi / 2;
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = 12;
    return c;
}

/// Of the last period, over that of one cycle of Mindlin and Deresiewicz (1953) between the same
/// forces on a contact that does not roll.
double work_ratio(const Case& c, const History& h) {
    const double cycle = theory::cycle_dissipation(
        {.friction_coefficient = c.friction_coefficient(),
         .normal_force = h.scales.normal_force,
         .effective_shear_modulus = c.materials().effective_shear_modulus(),
         .contact_radius = h.scales.contact_radius,
         .tangential_ratio = *c.load.tangential_ratio * c.load.tangential_amplitude_ratio});
    return h.dissipation_per_period.back() / cycle;
}

// The loop of an annulus that slips depends on the force's amplitude alone. The annulus is two of
// the 12 cells in the radius wide.
TEST(BemOscillatingForce, WithoutRollingItIsMindlinsLoop) {
    Case c = oscillating(0, 4, .4, 1);
    c.rolling->periods = 60;  // the shift's way to its loop falls by an eighth in each
    const History h = run_bem(c);
    EXPECT_EQ(h.verdict.state, State::cyclic_slip) << h.verdict.missing;
    EXPECT_NEAR(work_ratio(c, h), 1, .15);
    const History springs = contact::run(c, *mdr::make_model(c));
    EXPECT_EQ(springs.verdict.state, State::cyclic_slip);
    EXPECT_NEAR(work_ratio(c, springs), 1, 2e-3);  // 10000 springs
}

// Rolled, the points at the rim slip, which touch and leave in each period: more of them than in
// the loop without rolling, and not for the length of the steps.
TEST(BemOscillatingForce, RollingAddsWorkThatStepsDoNotEnd) {
    double work[3]{};
    for (int k = 0; k < 3; ++k) {
        const Case c = oscillating(.24, 4 << k);
        const History h = run_bem(c);
        EXPECT_EQ(h.verdict.state, State::cyclic_slip) << k << h.verdict.missing;
        const auto& shift = h.shift_per_period;
        EXPECT_NEAR(shift.back(), shift[shift.size() - 2], 1e-6 * h.scales.unit_shift);
        work[k] = work_ratio(c, h);
    }
    EXPECT_GT(work[0], 1);
    // It rises, by less each time: to a limit that is not 0.
    EXPECT_GT(work[1], work[0]);
    EXPECT_GT(work[2], work[1]);
    EXPECT_LT(work[2] - work[1], .8 * (work[1] - work[0]));
}

// Under constant loads friction comes to rest, whatever the steps: Melan.
TEST(BemOscillatingForce, ConstantLoadsShakeDown) {
    Case c = oscillating(.24, 8);
    c.load.tangential_amplitude_ratio = 0;
    c.rolling->periods = 60;
    const History h = run_bem(c);
    EXPECT_EQ(h.verdict.state, State::shakedown);
    // By the limit after one period; the work sinks with the shift, which settles.
    EXPECT_LT(h.dissipation_per_period.back(), 1e-5 * h.friction_limit * h.scales.unit_shift);
}

}  // namespace
}  // namespace tricontact::bem::bem_oscillating_force_test
