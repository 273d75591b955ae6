#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "bem/influence.h"
#include "contact/base/error.h"

namespace tricontact::layer_influence_test {
namespace {

using bem::InfluenceCoefficients;
using bem::LayerInfluence;
using bem::LayerKernel;
using bem::RectangleInfluence;
using theory::LayerBase;
using theory::LayerCompliance;
using theory::LayerStack;

constexpr double pi = std::numbers::pi;

double sinc(double x) {
    return std::abs(x) < 1e-8 ? 1 : std::sin(x) / x;
}

/// What layers add to the half-space's coefficients, by the inverse Fourier transform in polar
/// coordinates of the wave vector, the cell as a product of sincs: no Bessel functions, no table,
/// no points on the cell.
InfluenceCoefficients by_fourier(const LayerStack& stack, double h_x, double h_y, double x,
                                 double y) {
    const auto& top = stack.sheets.front();
    const double b = top.thickness, nu = top.material.poisson, g = top.material.shear_modulus();
    constexpr int n_panels = 160, n_angles = 256;
    using Rule = boost::math::quadrature::gauss<double, 8>;
    InfluenceCoefficients sum{};
    const double width = 24. / b / n_panels;
    for (int p = 0; p < n_panels; ++p)
        for (std::size_t q = 0; q < Rule::abscissa().size(); ++q)
            for (const int side : {-1, 1}) {
                const double k = (p + .5 + side * Rule::abscissa()[q] / 2) * width;
                const double weight = Rule::weights()[q] * width / 2 * k * (2 * pi / n_angles) /
                                      (4 * pi * pi) * h_x * h_y;
                const LayerCompliance c = theory::surface_compliance(stack, k);
                const double d33 = c.normal - (1 - nu) / (g * k),
                             d11 = c.along - (1 - nu) / (g * k), d22 = c.across - 1 / (g * k),
                             d13 = c.coupling - (1 - 2 * nu) / (2 * g * k);
                for (int a = 0; a < n_angles; ++a) {  // periodic: the trapezoidal rule is exact
                    const double cos = std::cos(2 * pi * a / n_angles),
                                 sin = std::sin(2 * pi * a / n_angles);
                    const double cell = weight * sinc(k * cos * h_x / 2) * sinc(k * sin * h_y / 2);
                    const double phase = k * (cos * x + sin * y), even = cell * std::cos(phase),
                                 odd = cell * std::sin(phase);
                    sum.zz += even * d33;
                    sum.xx += even * (d11 * cos * cos + d22 * sin * sin);
                    sum.yy += even * (d11 * sin * sin + d22 * cos * cos);
                    sum.xy += even * (d11 - d22) * sin * cos;
                    // u_along = i C13 p
                    sum.xz -= odd * d13 * cos;
                    sum.yz -= odd * d13 * sin;
                }
            }
    return sum;
}

void expect_fourier(const LayerStack& stack, double h_x, double h_y) {
    const auto& material = stack.sheets.front().material;
    const LayerInfluence layer(stack, {}, h_x, h_y, 6);
    const RectangleInfluence half_space({{}, material}, h_x, h_y);
    for (const auto& [x, y] :
         {std::pair(0., 0.), {.3, 0.}, {0., -.4}, {-.7, .5}, {1.6, -2.1}, {3.9, 3.1}}) {
        const auto exact = by_fourier(stack, h_x, h_y, x, y), all = layer.at(x, y),
                   without = half_space.at(x, y);
        // Of the coefficient of the cell under itself.
        const double tolerance = 1e-8 * half_space.at(0, 0).zz;
        const auto place = ::testing::Message()
                           << "nu " << material.poisson << " at " << x << ' ' << y;
        EXPECT_NEAR(all.zz - without.zz, exact.zz, tolerance) << place;
        EXPECT_NEAR(all.xx - without.xx, exact.xx, tolerance) << place;
        EXPECT_NEAR(all.yy - without.yy, exact.yy, tolerance) << place;
        EXPECT_NEAR(all.xy - without.xy, exact.xy, tolerance) << place;
        EXPECT_NEAR(all.xz - without.xz, exact.xz, tolerance) << place;
        EXPECT_NEAR(all.yz - without.yz, exact.yz, tolerance) << place;
    }
}

TEST(BemLayerInfluence, IsTheFourierTransformOfTheCompliance) {
    for (const double nu : {-.4, .3, .49, .5})
        expect_fourier({{{{2.3, nu}, 1}}, LayerBase::bonded, {}}, .15, .1);
    // Cells as large as the layer is thick.
    expect_fourier({{{{2.3, .5}, 1}}, LayerBase::bonded, {}}, 1, .7);
    expect_fourier({{{{2.3, .5}, 1}, {{8, .2}, .5}}, LayerBase::bonded, {}}, .15, .1);
    expect_fourier({{{{2.3, .5}, 1}}, LayerBase::bonded, contact::Material{5, .3}}, .15, .1);
    expect_fourier({{{{2.3, .3}, 1}}, LayerBase::bonded, contact::Material{1.2, .5}}, .15, .1);
}

// A bonded layer hardly feels a far force, where the half-space's 1/r is 2e-3 of the nearest.
TEST(BemLayerInfluence, FallsFasterThanTheHalfSpace) {
    const LayerStack stack{{{{2.3, .5}, 1}}, LayerBase::bonded, {}};
    const LayerInfluence layer(stack, {}, .1, .1, 20);
    const double near = layer.at(0, 0).zz;
    for (const double r : {12., 16., 19.}) {
        const auto k = layer.at(r, 0);
        for (const double value : {k.zz, k.xx, k.yy, k.xz})
            EXPECT_LT(std::abs(value), 1e-5 * near) << r;
    }
}

// Sum over a large patch: a uniform traction, which a bonded layer meets with its thickness.
TEST(BemLayerInfluence, UniformTraction) {
    const double nu = .3, e = 2.3, g = e / (2 * (1 + nu));
    const LayerStack stack{{{{e, nu}, 1}}, LayerBase::bonded, {}};
    const LayerInfluence layer(stack, {}, .5, .5, 25);
    double zz = 0, xx = 0;
    for (int i = -30; i <= 30; ++i)
        for (int j = -30; j <= 30; ++j) {
            const auto k = layer.at(.5 * i, .5 * j);
            zz += k.zz;
            xx += k.xx;
        }
    EXPECT_NEAR(zz * 2 * g * (1 - nu) / (1 - 2 * nu), 1, 1e-6);  // oedometer
    EXPECT_NEAR(xx * g, 1, 1e-6);
}

// Held at a distance, a gliding layer's mean shift there is zero, and what a force does nearby is
// a plate's: plane stress for long distances, ln r.
TEST(BemLayerKernel, GlidingLayerIsHeldFarAway) {
    const double nu = .3, g = 1.7, b = 1;
    const LayerStack stack{{{{2 * (1 + nu) * g, nu}, b}}, LayerBase::frictionless, {}};
    const LayerKernel kernel(stack, LayerKernel::frictionless_hold * b);
    const auto total_mean = [&](double r) {  // the half-space's: (1 - nu + nu/2)/(2 pi G r)
        return kernel.at(r).mean + (2 - nu) / (4 * pi * g * r);
    };
    // C11 -> (1 - nu)/(2 G b k^2), C22 -> 1/(G b k^2): logarithms of the sum of both, over two.
    const double factor = ((1 - nu) / 2 + 1) / (4 * pi * g * b);
    for (const double r : {8., 15., 30.})
        EXPECT_NEAR(total_mean(r) - total_mean(5), factor * std::log(5 / r), 2e-4 * factor) << r;
    EXPECT_NEAR(kernel.at(LayerKernel::frictionless_hold * b).mean, 0, 1e-6 * factor);
}

TEST(BemLayerInfluence, RefusesNonsense) {
    EXPECT_THROW(LayerInfluence({}, {}, .1, .1, 1), contact::InputError);
    EXPECT_THROW(LayerInfluence({{{{1, .3}, 0}}, LayerBase::bonded, {}}, {}, .1, .1, 1),
                 contact::InputError);
    EXPECT_THROW(LayerInfluence({{{{1, .3}, -1}}, LayerBase::bonded, {}}, {}, .1, .1, 1),
                 contact::InputError);
}

}  // namespace
}  // namespace tricontact::layer_influence_test
