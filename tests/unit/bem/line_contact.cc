#include "theory/layer/line_contact.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "bem/influence.h"
#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/solvers/contact_region.h"

namespace tricontact::line_contact_test {
namespace {

using contact::Case;

constexpr double pi = std::numbers::pi;

/// The thesis' rig with a cylinder (section 5.1.3).
Case rig(double cells_per_radius) {
    Case c;
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.radius = 40e-3;
    c.indenter.length = 80e-3;
    c.substrate = {3.6e6, .5};
    c.friction.coefficient = .79;
    c.load.normal_force = 32.3;
    c.load.tangential_ratio = .4;
    c.of<contact::Cells>().per_radius = cells_per_radius;
    return c;
}

contact::Scales pressed(const Case& c, bem::Body body) {
    const auto model = bem::make_model(c, 1, body);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    model->advance(step);
    return model->scales();
}

/// The coefficients of a long strip, one integration by Gauss and Kronrod's points and the other by
/// hand: ∫ 1/s dy = 2 asinh(l/x), ∫ x^2/s^3 dy = 2 l/s, ∫ x/s^2 dy = 2 atan(l/x).
double across_strip(const std::function<double(double)>& along, double x, double h) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    double sum = 0, error = 0;
    // Half the strip each, so that the singular line is an end of the intervals where x = 0.
    for (const double end : {x - h / 2, x + h / 2})
        sum += (end < x ? 1 : -1) * Rule::integrate(along, end, x, 15, 1e-13, &error);
    return sum;
}

TEST(BemLineContact, CoefficientsOfStripsTenThousandTimesAsLongAsWide) {
    const contact::Material material{2.3, .3};
    const double h = 1e-3, length = 10, l = length / 2, g = material.shear_modulus(), nu = .3;
    const bem::RectangleInfluence strip({{}, material}, h, length);
    for (const double x : {1e-3, 7e-3, .3}) {
        const auto k = strip.at(x, 0);
        const double one =
            across_strip([&](double s) { return 2 * std::asinh(l / std::abs(s)); }, x, h);
        const double xx = across_strip([&](double s) { return 2 * l / std::hypot(s, l); }, x, h);
        const double radial = across_strip([&](double s) { return 2 * std::atan(l / s); }, x, h);
        // Corners l away cancel down to h: 1e4 times the rounding.
        EXPECT_NEAR(k.zz / ((1 - nu) / (2 * pi * g) * one), 1, 1e-11) << x;
        EXPECT_NEAR(k.xx / (((1 - nu) * one + nu * xx) / (2 * pi * g)), 1, 1e-11) << x;
        EXPECT_NEAR(k.xz / (-(1 - 2 * nu) / (4 * pi * g) * radial), 1, 1e-10) << x;
    }
}

TEST(BemLineContact, HalfWidthFromMoments) {
    auto points = contact::ContactPoints::grid(301, 1, {-1.5, 0}, {.01, 7});
    points.line_length = 7;
    const auto of = [&](double a, double c1, double x0) {
        std::vector<double> p(points.size());
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double s = std::pow((points.x[i] - x0) / a, 2);
            p[i] = s < 1 ? std::sqrt(1 - s) * (1 + c1 * s) : 0;
        }
        return contact::contact_radius(points, p, {x0, 0}) / a;
    };
    // The edge is cut by cells, h^(3/2) of the moments.
    for (const double c1 : {0., .4, -.3}) {
        EXPECT_NEAR(of(1.003, c1, 0), 1, 1e-3) << c1;
        EXPECT_NEAR(of(.8, c1, .314), 1, 1e-3) << c1;
    }
}

// Hertz' line contact, and the displacement of its centre under a strip of the length L.
TEST(BemLineContact, HalfSpaceIsHertz) {
    for (const double nu : {0., .3, .5}) {
        Case c = rig(60);
        c.substrate.poisson = nu;
        const auto hertz = contact::half_space_scales(c);
        EXPECT_NEAR(
            hertz.peak_pressure,
            hertz.contact_radius * c.materials().effective_modulus() / (2 * c.indenter.radius),
            1e-9 * hertz.peak_pressure);  // Johnson (1985), eq. 4.45
        c.contact.coupling = false;
        const auto s = pressed(c, bem::Body::half_space);
        // Cells of a/60, and (a/L)^2 = 7e-4 in asinh for ln.
        EXPECT_NEAR(s.contact_radius / hertz.contact_radius, 1, 1e-3);
        EXPECT_NEAR(s.peak_pressure / hertz.peak_pressure, 1, 1e-3);
        EXPECT_NEAR(s.indentation / hertz.indentation, 1, 1e-3);
        EXPECT_NEAR(s.unit_shift / hertz.unit_shift, 1, 1e-3) << nu;
    }
}

TEST(BemLineContact, ScalesOfAPrescribedIndentation) {
    Case c = rig(20);
    const auto by_force = contact::half_space_scales(c);
    c.load.normal_force.reset();
    c.load.indentation = by_force.indentation;
    const auto by_depth = contact::half_space_scales(c);
    EXPECT_NEAR(by_depth.normal_force / by_force.normal_force, 1, 1e-13);
    EXPECT_NEAR(by_depth.contact_radius / by_force.contact_radius, 1, 1e-13);
    EXPECT_NEAR(by_depth.unit_shift / by_force.unit_shift, 1, 1e-13);
    c.load.indentation = 20e-3;
    EXPECT_THROW(contact::half_space_scales(c), contact::InputError);
}

// The exact plane contact of the rig on its layer of 5 mm; a/60 leaves 1e-3 at the edge.
TEST(BemLineContact, LayerIsTheExactPlaneContact) {
    for (const double nu : {.3, .5}) {
        Case c = rig(60);
        c.substrate.poisson = nu;
        c.layer.thickness = 5e-3;
        c.contact.coupling = false;
        const auto exact = theory::solve_line_contact(
            {c.substrate, 5e-3, theory::LayerBase::bonded}, c.indenter.radius,
            {theory::LineControl::Kind::load, *c.load.normal_force / c.indenter.length});
        const auto s = pressed(c, bem::Body::layer);
        EXPECT_NEAR(s.contact_radius / exact.half_width, 1, 1e-3);
        EXPECT_NEAR(s.peak_pressure / exact.centre_pressure, 1, 1e-3);
        EXPECT_NEAR(s.indentation / exact.indentation, 1, 1e-3);
    }
}

TEST(BemLineContact, HasNoTableOfSquareCells) {
    EXPECT_THROW(bem::case_influence(rig(10), 1, bem::Body::half_space), contact::InputError);
}

}  // namespace
}  // namespace tricontact::line_contact_test
