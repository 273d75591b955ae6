#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "contact/base/gauss_legendre.h"
#include "tests/unit/theory/layer/layer_cases.h"
#include "theory/layer/elastic_layer.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::layer_shakedown_test {
namespace {

using namespace layer_test;
using theory::amplitude_limit;
using theory::LayerBase;
using theory::shakedown_limit;

theory::LayerContact contact_at(double thickness, double nu, LayerBase base = LayerBase::bonded) {
    return theory::solve_layer_contact({{3e6, nu}, thickness, base}, contact::Paraboloid(.04),
                                       force(20));
}

TEST(LayerShakedown, IsHertzOnAThickLayer) {
    const auto thick = contact_at(1e6, .3);
    for (const double w : {0., .1, .24, .51, .9, 1.}) {
        EXPECT_NEAR(shakedown_limit(thick, w), theory::shakedown_limit(w), 1e-12) << w;
        const double f = theory::shakedown_limit(w);
        EXPECT_NEAR(amplitude_limit(thick, f), w, 1e-7) << w;  // flat at w = 1
    }
}

// (1/F) ∫ min p dA over the plane by quadrature of the pressures themselves: beyond the line
// x = W everything, mirrored.
double limit_by_pressures(const theory::LayerContact& c, double w) {
    const double a = c.contact_radius;
    const auto rule = contact::gauss_legendre(60);
    double sum = 0;
    // r dr from W to a, over the half angle acos(W/r) to both sides; x = r^2 has no root at W.
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const double s = rule.points[i], r = a * (w + (1 - w) * s * s);
        const double weight = rule.weights[i] * 2 * s * (1 - w) * a;
        sum += weight * r * 2 * std::acos(std::min(1., w * a / r)) * c.pressure(r);
    }
    return 2 * sum / c.normal_force;
}

TEST(LayerShakedown, IsTheIntegralOfTheLeastPressures) {
    for (const double nu : {.3, .5})
        for (const double thickness : {.5e-3, 2e-3, 8e-3})
            for (const double w : {.1, .24, .6}) {
                const auto c = contact_at(thickness, nu);
                // 60 points, the root of the pressure at the edge: O(n^-3)
                EXPECT_NEAR(shakedown_limit(c, w), limit_by_pressures(c, w), 1e-5)
                    << nu << ' ' << thickness << ' ' << w;
                EXPECT_NEAR(amplitude_limit(c, shakedown_limit(c, w)), w, 1e-12);
            }
}

// The least pressure is where the path is farthest from the axis, if pressures fall with r.
TEST(LayerShakedown, PressuresFallWithTheRadius) {
    for (const double nu : {0., .3, .5})
        for (const auto base : {LayerBase::bonded, LayerBase::frictionless})
            for (const double thickness : {.3e-3, 1e-3, 4e-3, 20e-3}) {
                const auto c = contact_at(thickness, nu, base);
                double before = c.pressure(0);
                for (double rho = .02; rho < .999; rho += .02) {
                    const double p = c.pressure(rho * c.contact_radius);
                    EXPECT_LT(p, before) << nu << ' ' << thickness << ' ' << rho;
                    before = p;
                }
            }
}

// Thin layers: a bonded incompressible one has p ~ (1 - r^2/a^2)^2 (lubrication), others
// p ~ 1 - r^2/a^2 (Winkler's bed); their line loads are (1 - x^2)^(5/2) and (1 - x^2)^(3/2).
double thin_limit(double w, bool incompressible) {
    const double root = std::sqrt(1 - w * w), cubic = w * root * (5 - 2 * w * w) / 3;
    return incompressible ? 1 - 2 / pi * (8. / 15 * w * std::pow(root, 5) + cubic + std::asin(w))
                          : 1 - 2 / pi * (cubic + std::asin(w));
}

TEST(LayerShakedown, TendsToThatOfThinLayers) {
    const double w = .3;
    for (const bool incompressible : {false, true}) {
        const double nu = incompressible ? .5 : .3;
        const double limit = thin_limit(w, incompressible);
        double before = 1;
        for (const double thickness : {.48e-3, .24e-3, .12e-3}) {
            const double error = shakedown_limit(contact_at(thickness, nu), w) - limit;
            // What is left is the edge, a few thicknesses wide: a ~ b^(1/4) and b^(1/2).
            EXPECT_LT(error / before, .85) << nu;
            before = error;
        }
        EXPECT_LT(before, .05);
    }
}

TEST(LayerShakedown, RefusesWhatIsOutOfRange) {
    const auto c = contact_at(8e-3, .5);
    EXPECT_THROW(shakedown_limit(c, 1.1), std::domain_error);
    EXPECT_THROW(shakedown_limit(c, -.1), std::domain_error);
    EXPECT_THROW(amplitude_limit(c, 1.1), std::domain_error);
    EXPECT_THROW(amplitude_limit(c, std::nan("")), std::domain_error);
}

}  // namespace
}  // namespace tricontact::layer_shakedown_test
