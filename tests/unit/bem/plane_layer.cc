#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/influence.h"
#include "bem/plane_layer_influence.h"
#include "contact/base/error.h"

namespace tricontact::plane_layer_test {
namespace {

using bem::InfluenceCoefficients;
using bem::LayerInfluence;
using bem::PlaneLayerInfluence;
using theory::LayerBase;
using theory::LayerStack;

constexpr double pi = std::numbers::pi;

/// A strip made of the cells of three dimensions, which have been tested on their own.
void expect_strip_of_cells(const LayerStack& stack,
                           const std::optional<contact::Material>& indenter) {
    const double h = .15, cell = .5;
    const int beside = 36;  // what a bonded layer shows 18 b away is below 1e-9
    const LayerInfluence cells(stack, {}, h, cell, 20);
    const PlaneLayerInfluence strip(stack, indenter, h, 36.5, 3);
    for (const double x : {0., .15, -.6, 1.7, 2.9}) {
        InfluenceCoefficients sum{};
        if (indenter) {
            sum = bem::RectangleInfluence({{}, *indenter}, h, 36.5).at(x, 0);
            sum.xz *= -1;
        }
        for (int j = -beside; j <= beside; ++j) {
            const auto k = cells.at(x, j * cell);
            sum.xx += k.xx;
            sum.yy += k.yy;
            sum.zz += k.zz;
            sum.xz += k.xz;
        }
        const auto k = strip.at(x);
        // Of the coefficient of a strip under itself: errors of the table of cells add up, 73
        // times.
        const double tolerance = 2e-6 * strip.at(0).zz;
        EXPECT_NEAR(k.zz, sum.zz, tolerance) << x;
        EXPECT_NEAR(k.xx, sum.xx, tolerance) << x;
        EXPECT_NEAR(k.yy, sum.yy, tolerance) << x;
        EXPECT_NEAR(k.xz, sum.xz, tolerance) << x;
        EXPECT_EQ(k.xy, 0);
    }
}

TEST(BemPlaneLayer, IsARowOfCells) {
    for (const double nu : {-.4, .3, .5})
        expect_strip_of_cells({{{{2.3, nu}, 1}}, LayerBase::bonded, {}}, {});
    expect_strip_of_cells({{{{2.3, .5}, 1}, {{8, .2}, .5}}, LayerBase::bonded, {}}, {});
    expect_strip_of_cells({{{{2.3, .5}, 1}}, LayerBase::bonded, {}}, contact::Material{7, .3});
}

// A uniform traction on the whole surface, which a bonded layer meets with its thickness.
TEST(BemPlaneLayer, UniformTraction) {
    const double nu = .3, e = 2.3, g = e / (2 * (1 + nu)), b = .8;
    const PlaneLayerInfluence strip({{{{e, nu}, b}}, LayerBase::bonded, {}}, {}, .5, 1, 25);
    InfluenceCoefficients sum{};
    for (int i = -50; i <= 50; ++i) {
        const auto k = strip.at(.5 * i);
        sum.xx += k.xx;
        sum.yy += k.yy;
        sum.zz += k.zz;
        sum.xz += k.xz;
    }
    EXPECT_NEAR(sum.zz * 2 * g * (1 - nu) / (1 - 2 * nu) / b, 1, 1e-9);  // oedometer
    EXPECT_NEAR(sum.xx * g / b, 1, 1e-9);
    EXPECT_NEAR(sum.yy * g / b, 1, 1e-9);
    EXPECT_NEAR(sum.xz, 0, 1e-12 * sum.zz);
}

// Far from a tangential line load a gliding layer is a rod of plane strain, half the load on either
// side: u' = (F/2) (1 - nu)/(2 G b).
TEST(BemPlaneLayer, GlidingLayerIsARodHeldFarAway) {
    const double nu = .3, g = 1.7, b = .6, h = .1;
    const double hold = bem::LayerKernel::frictionless_hold * b;
    const PlaneLayerInfluence strip({{{{2 * (1 + nu) * g, nu}, b}}, LayerBase::frictionless, {}},
                                    {}, h, 1, hold);
    const double slope = h / 2 * (1 - nu) / (2 * g * b);
    for (const double x : {4., 9., 20.})
        EXPECT_NEAR(strip.at(x).xx, slope * (hold - x), 1e-8 * slope * hold) << x;
    EXPECT_NEAR(strip.at(hold).xx, 0, 1e-12 * slope * hold);
}

// At a hundredth of the layer's thickness the layer is a half-space, but for its datum.
TEST(BemPlaneLayer, IsAHalfSpaceNearTheLoad) {
    const double nu = .2, e = 3, h = 1e-5;
    const PlaneLayerInfluence strip({{{{e, nu}, 1}}, LayerBase::bonded, {}}, {}, h, 1, .1);
    const bem::RectangleInfluence half_space({{}, {e, nu}}, h, 1e3);
    const auto k = strip.at(0), l = strip.at(4e-4), s = half_space.at(0, 0),
               t = half_space.at(4e-4, 0);
    EXPECT_NEAR((k.zz - l.zz) / (s.zz - t.zz), 1, 1e-6);  // (x/b)^2 is left
    EXPECT_NEAR((k.xx - l.xx) / (s.xx - t.xx), 1, 1e-6);
    EXPECT_NEAR(l.xz / t.xz, 1, 1e-3);  // x/b
}

TEST(BemPlaneLayer, RefusesAnElasticGround) {
    const LayerStack stack{{{{2.3, .5}, 1}}, LayerBase::bonded, contact::Material{5, .3}};
    EXPECT_THROW(PlaneLayerInfluence(stack, {}, .1, 1, 3), contact::InputError);
}

}  // namespace
}  // namespace tricontact::plane_layer_test
