// Tangential loading of the half-space boundary elements against Cattaneo (1938) and Mindlin
// (1949). Their solution neglects the small traction across the load, which vanishes for nu = 0
// only: there it is exact. Elastically similar bodies, so that nothing couples normal and
// tangential.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/bem_rig.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::bem {
namespace {

contact::Case loaded(double nu, double f, double cells_per_radius) {
    contact::Case c = rig_case(0, f, 1);
    c.rolling.reset();
    c.substrate = {5.2e6, nu};
    c.indenter.material = contact::Material{5.2e6, nu};
    c.bem.spacing.reset();
    c.bem.cells_per_radius = cells_per_radius;
    c.bem.tolerance = 1e-8;
    return c;
}

/// Relative deviation of the static shift from Cattaneo and Mindlin.
double deviation(double nu, double f, double cells_per_radius) {
    return static_ratio(run_bem(loaded(nu, f, cells_per_radius))) / theory::static_shift_ratio(f) -
           1;
}

TEST(BemCattaneoMindlin, ExactWithoutLateralContraction) {
    for (const double f : {0.1, 0.5, 0.9})
        EXPECT_NEAR(deviation(0, f, 22.5), 0, 1e-3) << f;  // stick radius cut by cells, O(h)
    // Second order up to the scatter of the cut edges: four times finer, at least eight times
    // better.
    EXPECT_LT(std::abs(deviation(0, 0.5, 64)), std::abs(deviation(0, 0.5, 16)) / 8);
}

// What the closed form neglects, converged in the grid (64 cells per radius): -0.037 % for nu =
// 0.3, -0.13 % for nu = 0.5 at f_T = 0.5. The transverse traction makes the contact a little
// stiffer.
TEST(BemCattaneoMindlin, NeglectedCrossTractionIsATenthOfAPercent) {
    EXPECT_NEAR(deviation(0.3, 0.5, 45), -3.6e-4, 1e-4);
    EXPECT_NEAR(deviation(0.5, 0.5, 45), -1.33e-3, 1e-4);
    EXPECT_GT(deviation(0, 0.5, 45), -1e-4);
}

TEST(BemCattaneoMindlin, TractionAndStickZone) {
    const double f = 0.56;
    const contact::Case c = loaded(0, f, 32);
    const contact::History h = run_bem(c);
    const contact::HertzScales hertz = hertz_scales(c);
    const contact::Surface& s = h.snapshots.front().surface;
    const double a = hertz.contact_radius, bound = c.friction_coefficient * hertz.peak_pressure;
    double worst = 0;
    for (int i = 0; i < s.n_x; ++i) {
        const double rho = std::abs(s.x(i)) / a;
        const std::size_t k = static_cast<std::size_t>(s.n_y / 2) * s.n_x + i;
        if (rho > 0.95) continue;
        const double exact = theory::cattaneo_mindlin_traction(rho, f);
        worst = std::max(worst, std::abs(s.tangential_traction_x[k] / bound - exact));
        EXPECT_NEAR(s.tangential_traction_y[k] / bound, 0, 1e-6);
    }
    // The square root at the stick radius over one cell: 0.05 sqrt-like, elsewhere below 0.01.
    EXPECT_LT(worst, 0.06);
    const double stick_area = h.steps.back().stick_area;
    EXPECT_NEAR(std::sqrt(stick_area / std::numbers::pi) / a, theory::stick_radius_ratio(f),
                0.02);  // counted cells: O(h)
}

// One cycle of F_T = +F, -F, +F after loading dissipates Mindlin's W0 (the form re-derived in
// theory/). Steps of a half cycle are exact: slip grows from the edge at constant bound.
TEST(BemCattaneoMindlin, CycleDissipation) {
    for (const double f : {0.6, 0.9}) {
        const contact::Case c = loaded(0, f, 32);
        const auto model = make_model(c, 1);
        contact::LoadStep step = press_step(c);
        model->advance(step);
        const contact::Scales scales = model->scales();
        const double force = f * c.friction_coefficient * scales.normal_force;
        auto dissipation_to = [&](double target) {
            step.tangential[0].value = target;
            return model->advance(step).dissipation;
        };
        dissipation_to(force);
        const double work = dissipation_to(-force) + dissipation_to(force);
        const double exact = theory::cycle_dissipation(
            {.friction_coefficient = c.friction_coefficient,
             .normal_force = scales.normal_force,
             .effective_shear_modulus = c.materials().effective_shear_modulus(),
             .contact_radius = hertz_scales(c).contact_radius,
             .tangential_ratio = f});
        EXPECT_NEAR(work / exact, 1, 1e-2) << f;  // slip annulus of a few cells: O(h)
    }
}

// With lateral contraction the limit is approached ever more slowly: slip directions fan out, and
// F_T -> mu F_N needs them parallel. f_T = 1 - 1e-6 converges, with a shift far beyond U_max.
TEST(BemCattaneoMindlin, LastMillionthOfFriction) {
    contact::Case c = loaded(0.5, 1 - 1e-6, 16);
    const contact::History h = run_bem(c);
    EXPECT_TRUE(h.audit.passed());
    EXPECT_GT(static_ratio(h), 5);
    EXPECT_LT(static_ratio(run_bem(loaded(0, 1 - 1e-6, 16))), 1.01);
}

}  // namespace
}  // namespace tricontact::bem
