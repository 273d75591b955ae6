#include "theory/layer/elastic_layer.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/base/error.h"
#include "contact/base/gauss_legendre.h"
#include "tests/unit/mdr/profiles.h"
#include "tests/unit/theory/layer/layer_cases.h"
#include "theory/contact_search.h"
#include "theory/hertz.h"
#include "theory/layer/layer_equation.h"

namespace tricontact::elastic_layer_test {
namespace {

using namespace layer_test;
using boost::math::quadrature::gauss_kronrod;
using theory::LayerBase;
using theory::solve_layer_contact;

// h0 = ∫ (1 - C33/C33_half-space) dx: a deep load lowers the surface by h0 F/(pi E* b) less.
double mean_deficit(double nu, LayerBase base) {
    auto deficit = [=](double x) { return theory::half_space_deficit(nu, base, x).normal; };
    return gauss_kronrod<double, 61>::integrate(deficit, 0., 24., 6, 1e-13);
}

// Coefficients c1, c2, ... of F/F_Hertz = 1 + c1 chi + c2 chi^2 + ..., by interpolation at
// chi = 0.01, 0.02, ... (Newton's divided differences, expanded).
std::vector<double> series(double nu, LayerBase base, int n) {
    std::vector<double> x, divided, c(n, 0.0);
    for (int i = 0; i < n; ++i) {
        x.push_back(.01 * (i + 1));
        divided.push_back((force_ratio(x[i], nu, base).force - 1) / x[i]);
    }
    for (int order = 1; order < n; ++order)
        for (int i = n - 1; i >= order; --i)
            divided[i] = (divided[i] - divided[i - 1]) / (x[i] - x[i - order]);
    for (int i = n - 1; i >= 0; --i) {  // c <- divided[i] + (chi - x[i]) c
        for (int k = n - 1; k > 0; --k) c[k] = c[k - 1] - x[i] * c[k];
        c[0] = divided[i] - x[i] * c[0];
    }
    return c;
}

TEST(ElasticLayer, GaussRule) {
    for (const int n : {1, 2, 7, 30, 301}) {
        const auto rule = contact::gauss_legendre(n);
        ASSERT_EQ(rule.points.size(), n);
        for (const int power : {0, 1, n, 2 * n - 1}) {
            double sum = 0;
            for (int i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.points[i], power);
            EXPECT_NEAR(sum * (power + 1), 1, 1e-15 * (10 + n)) << n << ' ' << power;  // roundings
        }
    }
}

TEST(ElasticLayer, SeriesForShallowContacts) {
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless})
        for (const double nu : {-.5, 0., .3, .5}) {
            const auto c = series(nu, base, 7);
            // To second order the layer lifts the whole contact: d -> d + h0 F/(pi E* b), so that
            // c1 = 2 h0/pi, c2 = 7/6 c1^2. Truncation: 0.01^7 7! c8 = 5e-11, noise 1e-13/0.01^2.
            const double c1 = 2 / pi * mean_deficit(nu, base);
            EXPECT_NEAR(c[0] / c1, 1, 1e-8) << nu;
            EXPECT_NEAR(c[1] / (7. / 6 * c1 * c1), 1, 1e-6) << nu;
        }
}

TEST(ElasticLayer, GarciaAndGarcia) {
    const auto c = series(.5, LayerBase::bonded, 7);
    EXPECT_NEAR(c[0], 1.12695, 5e-6);
    EXPECT_NEAR(c[1], 1.4817, 5e-5);
    // Garcia and Garcia (2018), Biophys. J. 114, from a kernel known to three digits: 1.1 %. Their
    // fourth coefficient, 0.755, is no Taylor coefficient of the exact curve.
    const double published[] = {1.133, 1.497, 1.469};
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(c[i] / published[i], 1, .011) << i;
}

TEST(ElasticLayer, ThickLayersAreHertzian) {
    for (const double nu : {-.5, 0., .5}) {
        contact::Case rig;
        rig.indenter.radius = .04;
        rig.substrate = {5.2e6, nu};
        rig.friction.coefficient = 1;
        rig.load.normal_force = 21.1;
        const auto hertz = contact::half_space_scales(rig);
        for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless}) {
            const double b = 1e4 * hertz.contact_radius;
            const auto c = solve_layer_contact({rig.substrate, b, base}, contact::Paraboloid(.04),
                                               force(21.1));
            // The layer lifts the contact as a whole, d = d_H (1 - 2/3 c1 a/b), and changes
            // its shape by (a/b)^3 = 1e-12; second order of d: 1e-8.
            const double c1 = 2 / pi * mean_deficit(nu, base);
            EXPECT_NEAR(c.contact_radius / hertz.contact_radius, 1, 1e-11);
            EXPECT_NEAR(c.normal_force / 21.1, 1, 1e-13);
            EXPECT_NEAR(c.centre_pressure / hertz.peak_pressure, 1, 1e-11);
            EXPECT_NEAR(c.indentation / hertz.indentation, 1 - 2. / 3 * c1 * 1e-4, 1e-8);
            EXPECT_NEAR(c.unit_shift.value_or(hertz.unit_shift) / hertz.unit_shift, 1, 1e-4);
            for (const double rho : {.1, .5, .9, .999, 1.1}) {
                const double r = rho * hertz.contact_radius;
                EXPECT_NEAR(
                    (c.pressure(r) - theory::hertz_pressure(hertz, r)) / hertz.peak_pressure, 0,
                    1e-10)  // the radius' 1e-12 under the edge's square root: 2e-11
                    << rho;
            }
        }
    }
}

TEST(ElasticLayer, SphereOnAThickLayer) {
    // Exact sphere on the half-space: d = a artanh(a/R), F = E* [(a^2 + R^2) artanh(a/R) - a R];
    // Segedin (1957). The layer of 1e9 a adds 1e-9.
    const double radius = .04, a = .02, modulus = 3e6;
    const double d = a * std::atanh(a / radius);
    const double f = modulus * ((a * a + radius * radius) * std::atanh(a / radius) - a * radius);
    const auto c = solve_layer_contact({{modulus * .75, .5}, 1e9 * a}, contact::Sphere(radius),
                                       indentation(d));
    EXPECT_NEAR(c.contact_radius / a, 1, 2e-9);
    EXPECT_NEAR(c.normal_force / f, 1, 2e-9);
}

TEST(ElasticLayer, SphereTendsToTheParaboloid) {
    auto difference = [](double radius) {  // of d at the same contact, chi about the rig's
        const theory::ElasticLayer layer{{5.2e6, .5}, 8e-3};
        const double f = 21.1 * .04 / radius;
        const auto sphere = solve_layer_contact(layer, contact::Sphere(radius), force(f));
        const auto paraboloid = solve_layer_contact(layer, contact::Paraboloid(radius), force(f));
        EXPECT_LT(sphere.contact_radius, paraboloid.contact_radius);
        return sphere.indentation / paraboloid.indentation - 1;
    };
    const double near = difference(.04), far = difference(.08);
    EXPECT_LT(std::abs(near), .01);   // (a/R)^2 = 1.2 %
    EXPECT_NEAR(near / far, 4, .05);  // second order in a/R, the next one is 1 %
}

TEST(ElasticLayer, KinkedIndenter) {
    const mdr_test::TwoCones indenter(.2, 1.1, .01);
    const theory::ElasticLayer thick{{2e6, .3}, 1e9}, thin{{2e6, .3}, .01};
    const double a = .02;
    const auto c = solve_layer_contact(thick, indenter, indentation(indenter.transformed(a)));
    EXPECT_NEAR(c.contact_radius / a, 1, 1e-10);
    auto load = [&](double x) { return indenter.transformed(a) - indenter.transformed(x); };
    const double inner = gauss_kronrod<double, 61>::integrate(load, 0, .01, 15, 1e-12);
    const double outer = gauss_kronrod<double, 61>::integrate(load, .01, a, 15, 1e-12);
    EXPECT_NEAR(c.normal_force / (2 * 2e6 / .91 * (inner + outer)), 1, 1e-9);
    EXPECT_TRUE(std::isinf(c.centre_pressure));
    const auto pressed = solve_layer_contact(thin, indenter, indentation(c.indentation));
    EXPECT_GT(pressed.normal_force, c.normal_force);
    // Pressure is infinite on the kink, but carries the force all the same.
    boost::math::quadrature::tanh_sinh<double> quadrature;
    auto ring = [&](double r) { return 2 * pi * r * pressed.pressure(r); };
    const double total = quadrature.integrate(ring, 0., .01, 1e-8) +
                         quadrature.integrate(ring, .01, pressed.contact_radius, 1e-8);
    EXPECT_NEAR(total / pressed.normal_force, 1, 1e-9);
}

TEST(ElasticLayer, ConePressure) {
    // Sneddon (1965): p = E* tan(slope)/2 acosh(a/r); the layer of 1e9 a adds 1e-9.
    const mdr_test::PowerLawIndenter cone(.3, 1);
    const double a = .01, modulus = 2e6 / .91;
    const auto c = solve_layer_contact({{2e6, .3}, 1e9 * a}, cone, indentation(.3 * pi / 2 * a));
    for (const double rho : {.1, .5, .9})
        EXPECT_NEAR(c.pressure(rho * a) / (modulus * .15 * std::acosh(1 / rho)), 1, 1e-8) << rho;
}

// The force of a pressure [N].
template <typename Pressure>
double total_of(const Pressure& pressure, double a) {
    auto ring = [&](double angle) {  // r = a sin(angle): smooth at the edge
        const double r = a * std::sin(angle);
        return 2 * pi * r * pressure(r) * a * std::cos(angle);
    };
    return gauss_kronrod<double, 61>::integrate(ring, 0, pi / 2, 1, 1e-10);
}

TEST(ElasticLayer, PunchPressureCarriesTheForceUpToTheThinnestLayer) {
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless})
        for (const double nu : {-.99, .5}) {
            const double a = 1e-3 * theory::largest_radius_over_thickness;
            const int n = theory::points_for(theory::largest_radius_over_thickness);
            const Punch punch = flat_punch({{3e6, nu}, 1e-3, base}, a, n);
            auto pressure = [&](double r) { return punch.line_load.pressure(r); };
            EXPECT_NEAR(total_of(pressure, a) / punch.force, 1, 1e-10) << nu;
        }
}

TEST(ElasticLayer, PressureCarriesTheForce) {
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless})
        for (const double chi : {.01, .5, 5.}) {
            const auto c = force_ratio(chi, .5, base).contact;
            const double total =
                total_of([&](double r) { return c.pressure(r); }, c.contact_radius);
            EXPECT_NEAR(total / c.normal_force, 1, 1e-10) << chi;  // as accurate as p
        }
}

TEST(ElasticLayer, StiffnessIsTheDerivativeOfTheForce) {
    for (const double nu : {-.5, .3, .5}) {
        const theory::ElasticLayer layer{{5.2e6, nu}, 8e-3};
        const contact::Sphere sphere(.04);
        const double d = 3e-4, step = 1e-3 * d;
        const auto above = solve_layer_contact(layer, sphere, indentation(d + step));
        const auto below = solve_layer_contact(layer, sphere, indentation(d - step));
        const auto c = solve_layer_contact(layer, sphere, indentation(d));
        const double slope = (above.normal_force - below.normal_force) / (2 * step);
        EXPECT_NEAR(c.normal_stiffness / slope, 1, 1e-6) << nu;  // central: step^2/d^2
        // and the other control finds the same state
        const auto again = solve_layer_contact(layer, sphere, force(c.normal_force));
        EXPECT_NEAR(again.indentation / d, 1, 1e-12) << nu;
    }
}

TEST(ElasticLayer, ConvergesSpectrally) {
    const theory::ElasticLayer layer{{5.2e6, .5}, 8e-3};
    auto total = [&](int n) {
        const theory::LayerEquation equation(layer, theory::LineMesh(.012, {}, n));
        std::vector<double> g(n);
        for (int i = 0; i < n; ++i) g[i] = std::pow(equation.mesh().positions()[i], 2);
        return equation.solve(g, .012 * .012).integral;
    };
    const double exact = total(60);
    auto error = [&](int n) { return std::abs(total(n) / exact - 1); };
    // exp(-2 n asinh(4 b/a)) = 27^-n; twelve points would do
    EXPECT_GT(error(3), 1e-6);
    EXPECT_LT(error(6), 1e-3 * error(3));
    EXPECT_LT(error(9), 1e-3 * error(6));
    EXPECT_LT(error(20), 1e-13);
}

TEST(ElasticLayer, ThinLayersFollowLubricationAndWinkler) {
    // Johnson (1985), section 5.8. Incompressible, bonded: p = 3 G (a^2 - r^2)^2/(32 R b^3), hence
    // d = a^2/(4 R), F = pi G a^6/(32 R b^3). Gliding: p = 2 G/((1 - nu) b) (d - r^2/(2 R)), hence
    // d = a^2/(2 R), F = pi G a^4/(2 (1 - nu) R b). Compared are the radii that these give for d
    // and F: the edge of width b displaces the radius in first order, F(d) only in second (bonded)
    // or third order (gliding).
    const double radius = .04, b = 1e-3, nu = .5;
    auto errors = [&](LayerBase base, double slimness) {
        const theory::ElasticLayer layer{{3e6, nu}, b, base};
        const double g = layer.material.shear_modulus(), a = slimness * b;
        const bool bonded = base == LayerBase::bonded;
        const auto c = solve_layer_contact(layer, contact::Paraboloid(radius),
                                           indentation(a * a / (bonded ? 4 : 2) / radius));
        const double of_force =
            bonded ? std::pow(32 * radius * b * b * b * c.normal_force / (pi * g), 1. / 6)
                   : std::pow(2 * (1 - nu) * radius * b * c.normal_force / (pi * g), 1. / 4);
        return std::array{c.contact_radius / a - 1, of_force / a - 1};
    };
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless}) {
        const auto thin = errors(base, 12), thinner = errors(base, 24);
        const double of_radius = std::log2(thin[0] / thinner[0]);
        const double of_force = std::log2(thin[1] / thinner[1]);
        EXPECT_LT(std::abs(thinner[0]), 1.5 / 24);
        EXPECT_LT(std::abs(thinner[1]), .006);
        EXPECT_NEAR(of_radius, 1, .2);  // the next order adds b/a, a few times 1/24
        EXPECT_NEAR(of_force, base == LayerBase::bonded ? 2 : 3, .2);
    }
}

TEST(ElasticLayer, GlidingLayersDependOnPoissonsRatioThroughTheModulusOnly) {
    const auto reference = force_ratio(1, .5, LayerBase::frictionless);
    for (const double nu : {-.9, 0., .3}) {
        const auto other = force_ratio(1, nu, LayerBase::frictionless);
        EXPECT_NEAR(other.force / reference.force, 1, 1e-12);  // C33 G/(1 - nu) is free of nu
        EXPECT_FALSE(other.contact.unit_shift.has_value());
    }
    // The bonded layer is stiffer, and much stiffer when incompressible.
    EXPECT_LT(reference.force, force_ratio(1, 0, LayerBase::bonded).force);
    EXPECT_LT(reference.force, .5 * force_ratio(1, .5, LayerBase::bonded).force);
}

}  // namespace
}  // namespace tricontact::elastic_layer_test
