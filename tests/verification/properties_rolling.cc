// What has to hold for every case, tried on random ones: both models, coarse grids.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "mdr/model.h"
#include "tests/verification/bem_rig.h"

namespace tricontact::bem {
namespace {

/// Random number in [low, high], on a grid of 1000 values so that failures print short.
double draw(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

contact::Case random_case() {
    contact::Case c = rig_case(draw(0.02, 1.1), draw(0.02, 0.97), *rc::gen::inRange(1, 4));
    c.rolling->angle = draw(-std::numbers::pi, std::numbers::pi);
    c.rolling->steps = contact::Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = *rc::gen::inRange(1, 5);
    c.bem.spacing.reset();
    c.bem.cells_per_radius = draw(6, 11);
    c.mdr.springs = 500;
    return c;
}

contact::History run_mdr(const contact::Case& c) {
    const auto model = mdr::make_model(c);
    return contact::run(c, *model);
}

/// Total of a field over the grid, in units of the field times area.
double total(const contact::Surface& s, const std::vector<double>& field) {
    double sum = 0;
    for (const double value : field) sum += value;
    return sum * s.spacing[0] * s.spacing[1];
}

// Looked at from the surfaces, not from the solver's own records.
RC_GTEST_PROP(RollingProperties, SurfacesObeyCoulombAndBalance, ()) {
    const contact::Case c = random_case();
    const contact::History h = run_bem(c);
    for (const auto& snapshot : h.snapshots) {
        const contact::Surface& s = snapshot.surface;
        const double peak = c.friction_coefficient * h.scales.peak_pressure;
        for (std::size_t i = 0; i < s.size(); ++i) {
            const double t = std::hypot(s.tangential_traction_x[i], s.tangential_traction_y[i]);
            RC_ASSERT(s.normal_traction[i] >= 0);
            RC_ASSERT(t <= c.friction_coefficient * s.normal_traction[i] + 1e-12 * peak);
            // Friction never drives: slip has a part along the traction on the substrate.
            RC_ASSERT(s.dissipation[i] >= -1e-6 * peak * h.scales.unit_shift);
        }
        // 1e-9: the forces' promise.
        RC_ASSERT(std::abs(total(s, s.normal_traction) / 21.1 - 1) < 1e-9);
        RC_ASSERT(std::abs(total(s, s.tangential_traction_x) - h.tangential_force) <
                  1e-9 * h.friction_limit);
        RC_ASSERT(std::abs(total(s, s.tangential_traction_y)) < 1e-9 * h.friction_limit);
    }
}

// Reflected in the x axis: same shift along, opposite shift across the load.
RC_GTEST_PROP(RollingProperties, MirroredRollingMirrorsTheShift, ()) {
    contact::Case c = random_case();
    const contact::History h = run_bem(c);
    c.rolling->angle = -c.rolling->angle;
    const contact::History mirrored = run_bem(c);
    RC_ASSERT(h.steps.size() == mirrored.steps.size());
    // Both within the solver's tolerance of the truth, step by step: errors add up.
    const double allowed = 1e-6 * h.scales.unit_shift * static_cast<double>(h.steps.size());
    for (std::size_t k = 0; k < h.steps.size(); ++k) {
        RC_ASSERT(std::abs(h.steps[k].shift[0] - mirrored.steps[k].shift[0]) < allowed);
        RC_ASSERT(std::abs(h.steps[k].shift[1] + mirrored.steps[k].shift[1]) < allowed);
    }
}

/// Final shift ratios of both cases and models agree.
void expect_same_ratios(const contact::Case& a, const contact::Case& b) {
    const contact::History bem_a = run_bem(a), bem_b = run_bem(b);
    const double allowed = 1e-6 * static_cast<double>(bem_a.steps.size());  // solver, per step
    RC_ASSERT(bem_a.steps.size() == bem_b.steps.size());
    RC_ASSERT(std::abs(final_ratio(bem_a) - final_ratio(bem_b)) <
              allowed * std::max(1.0, final_ratio(bem_a)));
    const double mdr_a = final_ratio(run_mdr(a)), mdr_b = final_ratio(run_mdr(b));
    RC_ASSERT(std::abs(mdr_a - mdr_b) < 1e-9 * std::max(1.0, mdr_a));  // exact steps: rounding
}

// Other units of length, force (hence of stress): the same physics in other numbers.
RC_GTEST_PROP(RollingProperties, UnitsDoNotMatter, ()) {
    const contact::Case c = random_case();
    contact::Case other = c;
    const double length = std::pow(10, draw(-6, 6)), force = std::pow(10, draw(-6, 6));
    const double stress = force / (length * length);
    other.indenter.radius *= length;
    other.indenter.material->young *= stress;
    other.substrate.young *= stress;
    *other.load.normal_force *= force;
    expect_same_ratios(c, other);
}

// u depends on w, f_T and nu only: other radius, load, friction and modulus, same ratios.
RC_GTEST_PROP(RollingProperties, OnlyRatiosCount, ()) {
    const contact::Case c = random_case();
    contact::Case other = c;
    other.indenter.radius *= draw(0.2, 5);
    other.friction_coefficient *= draw(0.1, 3);
    *other.load.normal_force *= draw(0.05, 20);
    const double stiffness = draw(0.1, 10);
    other.substrate.young *= stiffness;
    other.indenter.material->young *= stiffness;  // keeps Dundurs' beta and G1/G2
    expect_same_ratios(c, other);
}

/// Work of F_T less elastic energy less friction over the whole history, over mu F_N U_max.
double missing_energy(const contact::History& h) {
    double work = 0, friction = 0;
    for (std::size_t k = 1; k < h.steps.size(); ++k) {
        const auto &before = h.steps[k - 1], &now = h.steps[k];
        work += (before.tangential_force[0] + now.tangential_force[0]) / 2 *
                (now.shift[0] - before.shift[0]);
        friction += now.dissipation;
    }
    const contact::Surface& s = h.snapshots.back().surface;
    double energy = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
        energy += (s.tangential_traction_x[i] * s.displacement_x[i] +
                   s.tangential_traction_y[i] * s.displacement_y[i]) /
                  2 * s.spacing[0] * s.spacing[1];
    return (work - energy - friction) / (h.friction_limit * h.scales.unit_shift);
}

// Friction is counted with the tractions at the end of the steps; what that misses vanishes with
// the step. Whole cells per step; the loading itself (one step, half its work counted twice) is the
// same in all runs and drops out of the differences.
TEST(RollingEnergy, BalanceClosesWithTheStep) {
    auto missing = [](int n) {
        contact::Case c = rig_case(.5, .6, 2);
        c.rolling->amplitude_ratio.reset();
        c.rolling->amplitude = 12 * 2e-4;
        c.rolling->steps = contact::Case::Steps::per_quarter;
        c.rolling->steps_per_quarter = n;
        return missing_energy(run_bem(c));
    };
    const double m3 = missing(3), m6 = missing(6), m12 = missing(12);
    EXPECT_LT(std::abs(m12 - m6), 0.75 * std::abs(m6 - m3));  // first order: 0.5, with scatter
    EXPECT_LT(std::abs(m12 - m6), 0.05);
}

// The contact need not sit on a cell's centre: a path shifted by part of a cell changes u by the
// grid error only (0.5 % at 11 cells per radius: the edge is cut by other cells).
TEST(RollingGrid, PathBetweenTheCells) {
    contact::Case c = rig_case(.24, .56, 1);
    c.bem.spacing.reset();
    c.bem.cells_per_radius = 11;
    c.rolling->amplitude_ratio = 0.5;  // room on the grid for what follows
    const double cell = hertz_scales(c).contact_radius / 11;
    auto settled = [&](double dx, double dy) {
        const auto model = make_model(c, 1);
        contact::LoadStep step = press_step(c);
        step.offset = {dx, dy};
        model->advance(step);
        const contact::Scales scales = model->scales();
        step.tangential[0].value = 0.56 * c.friction_coefficient * scales.normal_force;
        double shift = model->advance(step).shift[0];
        for (int n = 0; n < 15; ++n)
            for (const double offset : {1., 0., -1., 0.}) {
                step.offset = {dx + 0.24 * offset * scales.contact_radius, dy};
                shift = model->advance(step).shift[0];
            }
        return shift / scales.unit_shift;
    };
    const double centred = settled(0, 0);
    EXPECT_NEAR(settled(0.5 * cell, 0) / centred, 1, 5e-3);
    EXPECT_NEAR(settled(0.3 * cell, 0.4 * cell) / centred, 1, 5e-3);
}

}  // namespace
}  // namespace tricontact::bem
