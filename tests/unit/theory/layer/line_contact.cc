#include "theory/layer/line_contact.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "contact/base/error.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::line_contact_test {
namespace {

using boost::math::quadrature::gauss_kronrod;
using theory::ElasticLayer;
using theory::LayerBase;
using theory::LineControl;
using theory::solve_line_contact;

constexpr double pi = std::numbers::pi;
constexpr LayerBase both_bases[] = {LayerBase::bonded, LayerBase::frictionless};

LineControl load(double value) {
    return {LineControl::Kind::load, value};
}
LineControl half_width(double value) {
    return {LineControl::Kind::half_width, value};
}
double effective_modulus(const ElasticLayer& layer) {
    const double nu = layer.material.poisson;
    return layer.material.young / (1 - nu * nu);
}

// Another program's numbers for the rig: R = 40 mm, L = 80 mm, F_N = 32.3 N, b = 5 mm.
TEST(TheoryLineContact, CylinderRig) {
    const auto c = solve_line_contact({{3.6e6, .5}, 5e-3}, .04, load(32.3 / .08));
    EXPECT_NEAR(2 * c.half_width, 3.861e-3, .5e-6);
    EXPECT_NEAR(c.centre_pressure, .1336e6, 50);
    EXPECT_NEAR(c.indentation, .0647e-3, .5e-7);
}

// Hertz: a^2 = 4 F' R/(pi E*), p0 = 2 F'/(pi a) (Johnson 1985, eq. 4.43, 4.45). The layer changes
// the shape of the contact by (a/b)^2. The approach by the kernel's constant at small distance:
// d = 2 F'/(pi E*) [ln(2b/a) + ln 2 + 1/2 + ∫ (exp(-2x) - deficit)/x dx].
TEST(TheoryLineContact, ThickLayersAreHertzian) {
    for (const LayerBase base : both_bases)
        for (const double nu : {-.5, 0., .3, .5}) {
            const double radius = .04, f = 400, b = 10;
            const ElasticLayer layer{{3e6, nu}, b, base};
            const double modulus = effective_modulus(layer);
            const double a = std::sqrt(4 * f * radius / (pi * modulus));
            const auto c = solve_line_contact(layer, radius, load(f));
            const double shape = a * a / (b * b);  // 5e-8 at most
            EXPECT_NEAR(c.half_width / a, 1, 10 * shape) << nu;
            EXPECT_NEAR(c.centre_pressure / (2 * f / (pi * a)), 1, 10 * shape) << nu;
            for (const double rho : {.3, .9, .999})
                EXPECT_NEAR(c.pressure(rho * a) / (2 * f / (pi * a)), std::sqrt(1 - rho * rho),
                            100 * shape)  // the edge's square root magnifies the radius' error
                    << rho;
            auto rest = [&](double x) {
                return (std::exp(-2 * x) - theory::half_space_deficit(nu, base, x).normal) / x;
            };
            const double constant = gauss_kronrod<double, 61>::integrate(rest, 0., 24., 8, 1e-13);
            const double d = 2 * f / (pi * modulus) * (std::log(4 * b / a) + .5 + constant);
            EXPECT_NEAR(c.indentation / d, 1, 10 * shape) << nu;
        }
}

// Error of a limit of thin layers at b/a = 1/12 and 1/24: first order, what is left small.
template <typename Error>
void expect_first_order(Error error, double largest) {
    const double coarse = error(1 / 12.), fine = error(1 / 24.);
    EXPECT_LT(std::abs(fine), largest);
    EXPECT_NEAR(std::log2(coarse / fine), 1, .2);
}

// Thin layers are a bed of springs, p = k [d - x^2/(2R)], k = C33(0)^-1: the oedometer's modulus
// over b if bonded, E*/b if it glides. F' = 2/3 k a^3/R at given a; the edge adds what is first
// order in b/a.
TEST(TheoryLineContact, ThinLayersAreSprings) {
    struct Row {
        double nu;
        LayerBase base;
    };
    for (const Row& row : {Row{.3, LayerBase::bonded}, Row{0, LayerBase::bonded},
                           Row{.5, LayerBase::frictionless}, Row{.2, LayerBase::frictionless}})
        expect_first_order(
            [&](double b) {
                const ElasticLayer layer{{3e6, row.nu}, b, row.base};
                const double stiffness = 1 / theory::layer_compliance(layer, 0).normal;
                const auto c = solve_line_contact(layer, 50, half_width(1));
                return c.load / (2. / 3 * stiffness / 50) - 1;
            },
            .1);
}

// A thin incompressible bonded layer flows: p'' = -(3 G/b^3) (d - x^2/(2R)), p = p' = 0 at the
// edge, so d = a^2/(6R), p = G (a^2 - x^2)^2/(8 R b^3) (Johnson 1985, section 5.8).
TEST(TheoryLineContact, ThinIncompressibleLayersFlow) {
    auto contact = [](double b) { return solve_line_contact({{3e6, .5}, b}, 50, half_width(1)); };
    expect_first_order(
        [&](double b) { return contact(b).load / (2 * 1e6 / (15 * 50 * b * b * b)) - 1; }, .35);
    expect_first_order([&](double b) { return contact(b).indentation * 300 - 1; }, .12);
}

// u_z under the pressure found, by another quadrature than the solver's: over wave numbers of the
// compliance itself, with the pressure's own cosine transform.
TEST(TheoryLineContact, DisplacesTheSurfaceOntoTheCylinder) {
    for (const LayerBase base : both_bases)
        for (const double a_over_b : {.3, 2.}) {
            const ElasticLayer layer{{3e6, .45}, 1, base};
            const double radius = 30;
            const auto c = solve_line_contact(layer, radius, half_width(a_over_b));
            auto transform = [&](double k) {  // ∫ p cos(k x) dx
                auto wave = [&](double angle) {
                    const double x = c.half_width * std::sin(angle);
                    return c.pressure(x) * std::cos(k * x) * c.half_width * std::cos(angle);
                };
                return 2 * gauss_kronrod<double, 61>::integrate(wave, 0., pi / 2, 2, 1e-10);
            };
            const double x = .6 * c.half_width;
            auto part = [&](double k) {
                return theory::layer_compliance(layer, k).normal * transform(k) * std::cos(k * x) /
                       pi;
            };
            double u = 0;
            const double end = 120 / c.half_width;
            for (int i = 0; i < 30; ++i)
                u +=
                    gauss_kronrod<double, 31>::integrate(part, i * end / 30, (i + 1) * end / 30, 0);
            // p^ falls as k^-3/2, C33 as 1/k: what lies beyond 120/a is 120^-2.5 of the whole.
            const double d = c.indentation - x * x / (2 * radius);
            EXPECT_NEAR(u / d, 1, 1e-4) << a_over_b;
        }
}

TEST(TheoryLineContact, IsConsistent) {
    for (const LayerBase base : both_bases)
        for (const double a_over_b : {.01, .5, 5., 30.}) {
            const ElasticLayer layer{{3e6, .5}, 2e-3, base};
            const double radius = .04, a = a_over_b * 2e-3;
            const auto c = solve_line_contact(layer, radius, half_width(a));
            auto ring = [&](double angle) {
                return 2 * c.pressure(a * std::sin(angle)) * a * std::cos(angle);
            };
            const double sum = gauss_kronrod<double, 61>::integrate(ring, 0., pi / 2, 6, 1e-12);
            EXPECT_NEAR(sum / c.load, 1, 1e-10) << a_over_b;
            EXPECT_EQ(c.pressure(1.0001 * a), 0);
            const auto by_load = solve_line_contact(layer, radius, load(c.load));
            EXPECT_NEAR(by_load.half_width / a, 1, 1e-9) << a_over_b;
            const auto by_depth =
                solve_line_contact(layer, radius, {LineControl::Kind::indentation, c.indentation});
            EXPECT_NEAR(by_depth.load / c.load, 1, 1e-9) << a_over_b;
            // Stiffness: that of the contact at rest, as the edge carries nothing.
            const auto more = solve_line_contact(layer, radius, half_width(a * (1 + 1e-4)));
            const auto less = solve_line_contact(layer, radius, half_width(a * (1 - 1e-4)));
            const double slope = (more.load - less.load) / (more.indentation - less.indentation);
            EXPECT_NEAR(slope / c.stiffness, 1, 1e-6) << a_over_b;  // 1e-8 times a curvature
        }
}

TEST(TheoryLineContact, LoadBeyondAPointIsTheIntegralOfThePressure) {
    for (const double b : {.3, 1., 50.}) {
        const auto c = solve_line_contact({{3.6, .45}, b, LayerBase::bonded}, 40,
                                          {LineControl::Kind::half_width, 1});
        for (const double x : {0., .26, .9}) {
            const double begin = std::asin(x);
            const double integral = gauss_kronrod<double, 31>::integrate(
                [&](double angle) { return 2 * c.pressure(std::sin(angle)) * std::cos(angle); },
                begin, std::acos(0.), 12, 1e-12);
            EXPECT_NEAR(c.load_beyond(x), integral, 1e-9 * c.load) << b << ' ' << x;
        }
        EXPECT_NEAR(c.load_beyond(0), c.load, 1e-12 * c.load);
        EXPECT_EQ(c.load_beyond(1.1), 0);
    }
    // Hertz, as theory/oscillating_cylinder.h has it.
    const auto thick = solve_line_contact({{3.6, .5}, 1e4, LayerBase::bonded}, 40,
                                          {LineControl::Kind::half_width, 1});
    EXPECT_NEAR(thick.load_beyond(.26) / thick.load, theory::line_shakedown_limit(.26), 1e-7);
}

TEST(TheoryLineContact, RefusesBadInput) {
    const ElasticLayer layer{{3e6, .5}, 5e-3};
    auto message = [&](const ElasticLayer& l, double radius, LineControl control) {
        try {
            solve_line_contact(l, radius, control);
        } catch (const contact::InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(message(layer, -.04, load(1)),
              "line contact: the radius must be positive and finite, but is -0.04; correct it");
    EXPECT_NE(message(layer, .04, load(0)).find("control must be positive"), std::string::npos);
    EXPECT_NE(message({{3e6, .5}, 0}, .04, load(1)).find("thickness must be"), std::string::npos);
    for (const auto& control : {load(1e12), half_width(1)})
        EXPECT_NE(message(layer, .04, control).find("exceeds 32 thicknesses"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::line_contact_test
