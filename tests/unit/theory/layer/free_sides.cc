// Limits of what free sides add, in forms that were not used to write it.
#include "theory/layer/free_sides.h"

#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

namespace tricontact::free_sides_test {
namespace {

using std::numbers::pi;

constexpr double poissons[] = {0, .2, .3, .45, .5};

// Poles of the layer's compliance in Fourier space, theory/layer/layer_compliance.h, lie at
// k b = i lambda: 2 kappa cosh 2x + 4 x^2 + 1 + kappa^2 = 0. At nu = 1/2 cos(lambda) = lambda.
TEST(FreeSides, DecayAsTheLayersPoles) {
    for (const double nu : poissons) {
        const double kappa = 3 - 4 * nu, x = theory::edge_decay(nu);
        EXPECT_NEAR(2 * kappa * std::cos(2 * x) - 4 * x * x + 1 + kappa * kappa, 0, 1e-12) << nu;
        // No root is closer to zero.
        for (double y = 0; y < .999 * x; y += x / 50)
            EXPECT_GT(2 * kappa * std::cos(2 * y) - 4 * y * y + 1 + kappa * kappa, 0) << nu;
    }
    EXPECT_NEAR(theory::edge_decay(.5), .739085133215, 1e-11);  // Dottie's number
}

TEST(FreeSides, OfThickBlocksIsTheCompressionOfAColumn) {
    const double t = 1e-3;  // what is left are terms of the order t
    for (const double nu : poissons) {
        // F b/(E pi rho^2) over F/(G b); in plane strain (1 - nu^2) b/(E 2 rho) over 1/G.
        const double disc = 1 / (2 * (1 + nu) * pi * t * t);
        EXPECT_NEAR(theory::disc_side_compliance(nu, t) / disc, 1, 5 * t) << nu;
        const double strip = (1 - nu * nu) / (2 * (1 + nu) * 2 * t);
        EXPECT_NEAR(theory::strip_side_compliance(nu, t) / strip, 1, 6 * t) << nu;
    }
}

TEST(FreeSides, DecayThereAndBack) {
    for (const double nu : poissons) {
        const double decay = 2 * theory::edge_decay(nu);
        for (const auto compliance : {theory::disc_side_compliance, theory::strip_side_compliance})
            EXPECT_NEAR(std::log(compliance(nu, 40) / compliance(nu, 41)), decay, 2e-2) << nu;
    }
}

theory::LayerContact sphere_contact(double radius) {
    return {.contact_radius = radius,
            .indentation = 2e-4,
            .normal_force = 3,
            .normal_stiffness = 1,
            .centre_pressure = 1,
            .unit_shift = {},
            .line_load = theory::LineLoad(theory::LineMesh(radius, {}, 2), {0, 0})};
}

// Laplace's method: (1/2 pi) of ∫ exp(-2 lambda h/(b cos(angle))) over each of four directions.
TEST(FreeSides, OfABlockAreCountedByTheirDirections) {
    const theory::ElasticLayer layer{{2e6, .5}, 4e-3, theory::LayerBase::bonded};
    const double h = 100e-3, lambda = theory::edge_decay(.5), t = h / layer.thickness;
    const double disc =
        theory::block_margin * 3 / (2e6 / 3 * 4e-3 * 2e-4) * theory::disc_side_compliance(.5, t);
    const auto effect = [&](const theory::BlockSides& sides) {
        return theory::side_effect(layer, sphere_contact(1e-6), sides);
    };
    const double side = disc / (2 * pi) * std::sqrt(pi / (lambda * t));
    EXPECT_NEAR(effect({h, h, h, h}) / (4 * side), 1, .02);  // next: (5/8 - ...)/(lambda t)
    EXPECT_NEAR(effect({h, 9 * h, 9 * h, 9 * h}) / side, 1, .02);
    EXPECT_NEAR(effect({9 * h, 9 * h, h, 9 * h}) / effect({9 * h, h, 9 * h, 9 * h}), 1, 1e-9);
}

// The mean of I0 over p ~ sqrt(1 - r^2), of cosh over sqrt(1 - x^2), by the rule of midpoints.
TEST(FreeSides, SpreadOverHertzsPressure) {
    const theory::ElasticLayer layer{{2e6, .3}, 4e-3, theory::LayerBase::bonded};
    const theory::BlockSides sides{.05, .05, .05, .05};
    for (const double a : {2e-5, 4e-3, 16e-3}) {
        const double z = theory::edge_decay(.3) * a / layer.thickness;
        double disc = 0, strip = 0;
        constexpr int n = 4000;
        for (int i = 0; i < n; ++i) {
            const double r = (i + .5) / n, p = std::sqrt(1 - r * r);
            disc += 3 * p * r * boost::math::cyl_bessel_i(0, z * r) / n;
            strip += 4 / pi * p * std::cosh(z * r) / n;
        }
        const double point = theory::side_effect(layer, sphere_contact(1e-9), sides);
        EXPECT_NEAR(theory::side_effect(layer, sphere_contact(a), sides) / point, disc * disc,
                    1e-4 * disc * disc);  // the rule's error at the root's end
        const auto line = [&](double half_width) {
            return theory::side_effect(layer,
                                       theory::LineContact{.half_width = half_width,
                                                           .indentation = 2e-4,
                                                           .load = 300,
                                                           .stiffness = 1,
                                                           .centre_pressure = 1,
                                                           .edge_load_modes = {}},
                                       .05, .05);
        };
        EXPECT_NEAR(line(a) / line(1e-9), strip * strip, 1e-4 * strip * strip);
    }
}

}  // namespace
}  // namespace tricontact::free_sides_test
