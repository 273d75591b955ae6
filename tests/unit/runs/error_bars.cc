// Half widths of runs beside closed forms: they cover what coarse cells and springs are off.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/models/make_model.h"
#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/quantities.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "mdr/settings.h"
#include "runs/numerical_error.h"

namespace tricontact::run_error_bars_test {
namespace {

using comparisons::NumericalError;
using comparisons::Quantity;
using contact::Case;
namespace quantities = comparisons::quantities;

constexpr double radius = .04, modulus = 5.2e6, force = 21.1;

/// Without F_T and coupling (nu = 0, E* = E): Hertz.
Case pressed_sphere(const char* model) {
    Case c;
    c.models = {model};
    c.indenter.radius = radius;
    c.substrate = {modulus, 0};
    c.friction.coefficient = .57;
    c.contact.coupling = false;
    c.load.press = Case::Press::frictionless;
    c.load.normal_force = force;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().per_radius = 19.3;
    c.of<mdr::Settings>().springs = 90;
    return c;
}

NumericalError error_of(const Case& c) {
    runs::RunOptions options;
    options.makers = &app::model_makers();
    const contact::History history = options.runner().history_of(c.models.front(), c);
    return *runs::numerical_error(c, history, options, contact::silent);
}

/// The value is off the exact one by less than its half width, which is below `largest` of it.
void expect_covered(const NumericalError& error, const Quantity& q, double exact, double largest) {
    SCOPED_TRACE(error.model + ' ' + q.key);
    const auto value = error.run->results.number(q), width = error.of(q);
    ASSERT_TRUE(value && width) << error.why_none;
    EXPECT_GT(*width, 0);
    EXPECT_LE(std::abs(*value - exact), *width);
    EXPECT_LT(*width, largest * exact);
}

// Johnson, Contact Mechanics (1985), eqs. 4.22 to 4.24: a^3 = 3 F R/(4 E*), d = a^2/R,
// p0 = (6 F E*^2/(pi^3 R^2))^(1/3), and the work of pressing, 2/5 F d. Cells are counted in the
// area: some percent are left.
TEST(RunErrorBars, CoverHertzSphere) {
    const double a = std::cbrt(3 * force * radius / (4 * modulus)), d = a * a / radius;
    const double p0 = std::cbrt(6 * force * modulus * modulus / std::pow(std::numbers::pi, 3)) /
                      std::pow(radius, 2. / 3);
    for (const char* model : {contact::models::mdr, contact::models::bem}) {
        const NumericalError error = error_of(pressed_sphere(model));
        expect_covered(error, quantities::indentation, d, .02);
        expect_covered(error, quantities::end_indentation, d, .02);
        expect_covered(error, quantities::contact_radius, a, .1);
        expect_covered(error, quantities::peak_pressure, p0, .1);
        expect_covered(error, quantities::contact_area, std::numbers::pi * a * a, .2);
        expect_covered(error, quantities::stored_energy, .4 * force * d, .02);
        EXPECT_TRUE(error.is_exact(quantities::normal_force));
        EXPECT_EQ(error.of(quantities::end_normal_force), 0);
    }
}

// Under a prescribed depth the forces are what is computed: F = 4/3 E* sqrt(R) d^(3/2).
TEST(RunErrorBars, CoverTheForceOfADepth) {
    const double d = 4e-4, exact = 4. / 3 * modulus * std::sqrt(radius) * std::pow(d, 1.5);
    for (const char* model : {contact::models::mdr, contact::models::bem}) {
        Case c = pressed_sphere(model);
        c.load.normal_force.reset();
        c.load.indentation = d;
        const NumericalError error = error_of(c);
        expect_covered(error, quantities::normal_force, exact, .02);
        expect_covered(error, quantities::end_normal_force, exact, .02);
        EXPECT_EQ(error.of(quantities::end_indentation), 0);
    }
}

// Hertz' line contact: a = (4 F R/(pi L E*))^(1/2), p0 = 2 F/(pi a L) (Johnson 1985, 4.43, 4.45).
TEST(RunErrorBars, CoverTheLineContact) {
    Case c = pressed_sphere(contact::models::bem);
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.length = .1;
    c.of<contact::Cells>().per_radius = 11.7;
    const double a = std::sqrt(4 * force * radius / (std::numbers::pi * .1 * modulus));
    const NumericalError error = error_of(c);
    expect_covered(error, quantities::contact_radius, a, .2);
    expect_covered(error, quantities::contact_area, 2 * a * .1, .2);
    expect_covered(error, quantities::peak_pressure, 2 * force / (std::numbers::pi * a * .1), .1);
}

// The layer beside the Fredholm equation (theory/layer): exact for what mdr-layer computes without
// friction.
TEST(RunErrorBars, CoverTheExactLayer) {
    for (const char* model : {contact::models::mdr_layer, contact::models::bem_layer}) {
        Case c = pressed_sphere(model);
        c.substrate.poisson = .3;
        c.layer.thickness = 8e-3;
        c.of<mdr::Settings>().elements_per_radius = 40;
        const auto exact = comparisons::exact_layer_contact(c).value();
        const NumericalError error = error_of(c);
        expect_covered(error, quantities::indentation, exact.indentation, .02);
        expect_covered(error, quantities::contact_radius, exact.contact_radius, .1);
        expect_covered(error, quantities::peak_pressure, exact.centre_pressure, .1);
    }
}

// Cattaneo and Mindlin: F_T of a prescribed shift, F_T = mu F (1 - (1 - U/U_max)^(3/2)), and the
// work of friction on the way; stick radius c^3/a^3 = 1 - F_T/(mu F) (Johnson 1985, 7.40, 7.42).
TEST(RunErrorBars, CoverTheForceOfAShift) {
    const double a = std::cbrt(3 * force * radius / (4 * modulus)), mu = .57;
    for (const char* model : {contact::models::mdr, contact::models::bem}) {
        Case c = pressed_sphere(model);
        c.load.tangential_force.reset();
        contact::PrescribedPath path;
        path.rows.resize(2);
        for (auto& row : path.rows) row.normal = {contact::NormalControl::Kind::force, force};
        path.rows[1].steps = 8;
        // nu = 0: E* = E and G* = 4 G/(2 - nu) = E, so that U_max = mu E*/G* d = mu d.
        const double shift = .5 * mu * a * a / radius;
        for (int r = 0; r < 2; ++r)
            path.rows[r].tangential[0] = {contact::TangentialControl::Kind::shift, r * shift};
        c.load.normal_force = force;
        c.prescribed_path = path;
        const NumericalError error = error_of(c);
        const double ratio = 1 - std::pow(.5, 1.5), stick = std::pow(1 - ratio, 2. / 3) * a * a;
        expect_covered(error, quantities::path_force, mu * force * ratio, .05);
        expect_covered(error, quantities::stick_area, std::numbers::pi * stick, .3);
        expect_covered(error, quantities::slip_area, std::numbers::pi * (a * a - stick), .4);
        EXPECT_EQ(error.of(quantities::final_shift), 0);
    }
}

}  // namespace
}  // namespace tricontact::run_error_bars_test
