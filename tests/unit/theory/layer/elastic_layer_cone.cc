// A cone h = m r: its contact is the same whatever its size, but for the layer's thickness.
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "tests/unit/mdr/profiles.h"
#include "tests/unit/theory/layer/layer_cases.h"

namespace tricontact::elastic_layer_cone_test {
namespace {

using namespace layer_test;
using theory::LayerBase;
using theory::solve_layer_contact;

constexpr double slope = .2;

theory::LayerContact press(double thickness, double nu, LayerBase base,
                           contact::NormalControl control) {
    return solve_layer_contact({{2e6, nu}, thickness, base}, mdr_test::PowerLawIndenter(slope, 1),
                               control);
}

// Sneddon (1965): d = pi/2 m a, F = 2 E* d^2/(pi m); a thick layer lifts the contact by
// h0 F/(pi E* b), of the order a/b.
TEST(ElasticLayerCone, ThickLayersAreSneddon) {
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless})
        for (const double nu : {-.5, .3, .5}) {
            const double a = 2e-3, d = pi / 2 * slope * a, modulus = 2e6 / (1 - nu * nu);
            const auto c = press(1e8 * a, nu, base, indentation(d));
            EXPECT_NEAR(c.contact_radius / a, 1, 1e-7);
            EXPECT_NEAR(c.normal_force / (2 * modulus * d * d / (pi * slope)), 1, 1e-7);
            EXPECT_NEAR(c.normal_stiffness / (2 * modulus * a), 1, 1e-7);
        }
}

TEST(ElasticLayerCone, IsConsistentOnThinLayers) {
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless})
        for (const double depth : {.05, .5, 3.}) {  // d/(m b)
            const double b = 1.5e-3, d = depth * slope * b;
            const auto c = press(b, .5, base, indentation(d));
            EXPECT_TRUE(std::isinf(c.centre_pressure));
            const auto by_force = press(b, .5, base, force(c.normal_force));
            EXPECT_NEAR(by_force.indentation / d, 1, 1e-9) << depth;
            // dF/dd: the edge carries nothing.
            const double more = press(b, .5, base, indentation(d * 1.0001)).normal_force,
                         less = press(b, .5, base, indentation(d * .9999)).normal_force;
            EXPECT_NEAR((more - less) / (2e-4 * d) / c.normal_stiffness, 1, 1e-6) << depth;
            // The pressure, infinite at the tip as a logarithm, carries the force.
            boost::math::quadrature::tanh_sinh<double> quadrature;
            auto ring = [&](double r) { return 2 * pi * r * c.pressure(r); };
            const double total = quadrature.integrate(ring, 0., c.contact_radius, 1e-9);
            EXPECT_NEAR(total / c.normal_force, 1, 1e-8) << depth;
            // F/(E m b^2) is a function of d/(m b) alone.
            const auto larger = press(3 * b, .5, base, indentation(3 * d));
            EXPECT_NEAR(larger.normal_force / (9 * c.normal_force), 1, 1e-9) << depth;
        }
}

// To first order in a/b the layer lifts the whole contact by h0 F/(pi E* b), h0 the integral of the
// deficit: d -> d + 2 h0 d^2/(pi^2 m b), so F/F_Sneddon = 1 + 4 h0 d/(pi^2 m b). At nu = 1/2
// h0 = pi/2 1.12695 (tests of the paraboloid).
TEST(ElasticLayerCone, FirstOrderOfShallowContacts) {
    const double b = 1.5e-3, modulus = 2e6 / .75;
    auto coefficient = [&](double depth) {
        const double d = depth * slope * b;
        const double f = press(b, .5, LayerBase::bonded, indentation(d)).normal_force;
        return (f / (2 * modulus * d * d / (pi * slope)) - 1) / depth;
    };
    const double extrapolated = 2 * coefficient(.001) - coefficient(.002);
    EXPECT_NEAR(extrapolated / (2 / pi * 1.12695), 1, 2e-5);  // second order of the extrapolation
}

}  // namespace
}  // namespace tricontact::elastic_layer_cone_test
