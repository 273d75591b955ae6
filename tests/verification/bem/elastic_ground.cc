#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/influence.h"

namespace tricontact::bem_elastic_ground_test {
namespace {

using bem::LayerInfluence;
using contact::Material;
using theory::LayerBase;

constexpr double h = .15, b = 1;

// The coefficients are the integral over all wave numbers, on softer and on stiffer ground: seen
// from far away the ground's, (1 - nu)/(2 pi G r).
TEST(BemElasticGround, IsSeenFromFarAway) {
    const Material sheet{2.3, .3};
    for (const double ratio : {.1, 10., 1000.}) {
        const Material ground{ratio * sheet.young, .4};
        const LayerInfluence layer({{{sheet, b}}, LayerBase::bonded, ground}, {}, h, h, 1100);
        const auto far = [&](double r) {
            const double point = .6 / (2 * std::numbers::pi * ground.shear_modulus() * r);
            return std::abs(layer.at(r, 0).zz / (h * h) / point - 1);
        };
        // A stiff plate spreads the force over (E/E_ground)^(1/3) b, a soft one is nothing but its
        // compliance under its own force; of either the square over r^2 is left.
        EXPECT_LT(far(1000), 1e-4) << ratio;
    }
}

}  // namespace
}  // namespace tricontact::bem_elastic_ground_test
