// Normal contact of the half-space boundary elements against Hertz (1882) and against the method of
// dimensionality reduction, which is exact for frictionless bodies of revolution.

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/model.h"
#include "tests/verification/bem_rig.h"
#include "theory/hertz.h"

namespace tricontact::bem {
namespace {

contact::Case pressed(double cells_per_radius) {
    contact::Case c = rig_case(0, 0.5, 1);
    c.rolling.reset();
    c.bem.spacing.reset();
    c.bem.cells_per_radius = cells_per_radius;
    c.bem.tolerance = 1e-8;
    return c;
}

contact::Scales scales_of(const contact::Case& c) {
    const auto model = make_model(c, 1);
    model->advance(press_step(c));
    return model->scales();
}

/// Relative errors against Hertz.
struct Errors {
    double indentation, peak_pressure, contact_radius, unit_shift;
};

Errors errors_at(double cells_per_radius) {
    const contact::Case c = pressed(cells_per_radius);
    const contact::Scales s = scales_of(c);
    const contact::HertzScales hertz = hertz_scales(c);
    return {std::abs(s.indentation / hertz.indentation - 1),
            std::abs(s.peak_pressure / hertz.peak_pressure - 1),
            std::abs(s.contact_radius / hertz.contact_radius - 1),
            std::abs(s.unit_shift / hertz.unit_shift - 1)};
}

// The demand at 45 cells across the contact is 0.1, 0.3 and 0.5 %; we hold a tenth of it.
TEST(BemHertz, ScalesAt45CellsAcross) {
    const Errors e = errors_at(22.5);
    EXPECT_LT(e.indentation, 2e-4);
    EXPECT_LT(e.peak_pressure, 2e-4);
    EXPECT_LT(e.contact_radius, 5e-4);
    EXPECT_LT(e.unit_shift, 2e-4);  // u_x under mu p is u_z times mu E*/G*, hence like d
}

// Over five grids, odd and even numbers of cells: slope of the errors in a log-log plot. The edge
// is cut by square cells, whose error scatters with the grid; pressures vanish there like a square
// root, which leaves between first and second order.
TEST(BemHertz, OrdersOfConvergence) {
    const double radii[] = {11, 16, 23, 45, 90};
    double sx = 0, sxx = 0, sd = 0, sxd = 0, sp = 0, sxp = 0, sa = 0, sxa = 0;
    const int n = 5;
    for (const double cells : radii) {
        const Errors e = errors_at(cells);
        const double x = std::log(cells);
        sx += x, sxx += x * x;
        sd += std::log(e.indentation), sxd += x * std::log(e.indentation);
        sp += std::log(e.peak_pressure), sxp += x * std::log(e.peak_pressure);
        sa += std::log(e.contact_radius), sxa += x * std::log(e.contact_radius);
    }
    auto order = [&](double sy, double sxy) { return -(n * sxy - sx * sy) / (n * sxx - sx * sx); };
    EXPECT_GT(order(sd, sxd), 1.5);
    EXPECT_GT(order(sp, sxp), 1.5);
    EXPECT_GT(order(sa, sxa), 1.5);
}

TEST(BemHertz, PressureProfile) {
    const contact::Case c = pressed(22.5);
    const auto model = make_model(c, 1);
    model->advance(press_step(c));
    const contact::Surface s = model->surface();
    const contact::HertzScales hertz = hertz_scales(c);
    double worst_inside = 0, worst = 0;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const double r = std::hypot(s.x(i), s.y(j));
            const double exact = theory::hertz_pressure(hertz, r);
            const double error =
                std::abs(s.normal_traction[j * s.n_x + i] - exact) / hertz.peak_pressure;
            worst = std::max(worst, error);
            if (r < 0.9 * hertz.contact_radius) worst_inside = std::max(worst_inside, error);
        }
    EXPECT_LT(worst_inside, 5e-3);
    // A cell at the edge carries the mean of a square root: sqrt(h/a) = 0.2 times a shape factor.
    EXPECT_LT(worst, 0.15);
}

TEST(BemHertz, IndentationControlIsForceControl) {
    contact::Case c = pressed(16);
    const contact::Scales force_controlled = scales_of(c);
    c.load.normal_force.reset();
    c.load.indentation = force_controlled.indentation;
    const contact::Scales s = scales_of(c);
    EXPECT_NEAR(s.normal_force / force_controlled.normal_force, 1, 1e-6);  // both to tolerance 1e-9
    EXPECT_NEAR(s.peak_pressure / force_controlled.peak_pressure, 1, 1e-6);
}

// The exact ball at a/R = 0.4, where Hertz' paraboloid is off by a percent in F(d): MDR has the
// exact profile transform x/2 ln((R+x)/(R-x)).
TEST(BemHertz, ExactSphereAgreesWithReduction) {
    contact::Case c = pressed(22.5);
    c.indenter.shape = contact::Case::Shape::sphere;
    c.load.normal_force = 1000;
    const auto reduced = mdr::make_model(c);
    reduced->advance(press_step(c));
    const contact::Scales exact = reduced->scales(), s = scales_of(c);
    EXPECT_GT(std::abs(exact.indentation / hertz_scales(c).indentation - 1), 1e-2);
    EXPECT_NEAR(s.indentation / exact.indentation, 1, 5e-4);
    EXPECT_NEAR(s.contact_radius / exact.contact_radius, 1, 1e-3);
    EXPECT_NEAR(s.peak_pressure / exact.peak_pressure, 1, 1e-3);
}

// Two elastic bodies: only E* counts.
TEST(BemHertz, TwoElasticBodies) {
    contact::Case c = pressed(16);
    const contact::Scales one = scales_of(c);
    c.indenter.material = contact::Material{5.2e6, 0.5};
    c.substrate = {5.2e6, 0.5};
    const double e_star = c.materials().effective_modulus();
    c.load.normal_force =
        *pressed(16).load.normal_force * e_star / pressed(16).materials().effective_modulus();
    const contact::Scales two = scales_of(c);
    EXPECT_NEAR(two.indentation / one.indentation, 1, 1e-9);
}

}  // namespace
}  // namespace tricontact::bem
