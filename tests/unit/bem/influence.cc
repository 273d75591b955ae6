#include "bem/influence.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace tricontact::influence_test {
namespace {

using bem::InfluenceCoefficients;
using bem::RectangleInfluence;
using contact::Material;
using contact::MaterialPair;
using std::numbers::pi;

constexpr double width_x = .8, width_y = 1.3;
constexpr double InfluenceCoefficients::*all[] = {
    &InfluenceCoefficients::xx, &InfluenceCoefficients::xy, &InfluenceCoefficients::yy,
    &InfluenceCoefficients::xz, &InfluenceCoefficients::yz, &InfluenceCoefficients::zz};

/// Displacements of one body at (x, y) from a unit point force on its surface at the origin, z into
/// the body: Johnson (1985), eq. 3.18 (Boussinesq) and 3.75 (Cerruti) at z = 0.
InfluenceCoefficients point_force(const Material& m, double x, double y) {
    const double g = m.shear_modulus(), nu = m.poisson, s = std::hypot(x, y);
    const double q = 1 / (2 * pi * g), coupling = (1 - 2 * nu) / (4 * pi * g) / (s * s);
    return {.xx = q * ((1 - nu) / s + nu * x * x / (s * s * s)),
            .xy = q * nu * x * y / (s * s * s),
            .yy = q * ((1 - nu) / s + nu * y * y / (s * s * s)),
            .xz = -coupling * x,  // towards a pressing force, and so the surface sinks ahead of one
            .yz = -coupling * y,
            .zz = q * (1 - nu) / s};
}

/// Both bodies: the indenter is a half-space turned upside down under the opposite tractions.
InfluenceCoefficients point_force(const std::optional<Material>& indenter,
                                  const Material& substrate, double x, double y) {
    InfluenceCoefficients k = point_force(substrate, x, y);
    if (!indenter) return k;
    const InfluenceCoefficients other = point_force(*indenter, x, y);
    for (const auto term : {&InfluenceCoefficients::xx, &InfluenceCoefficients::xy,
                            &InfluenceCoefficients::yy, &InfluenceCoefficients::zz})
        k.*term += other.*term;
    for (const auto term : {&InfluenceCoefficients::xz, &InfluenceCoefficients::yz})
        k.*term -= other.*term;
    return k;
}

using Kernel = std::function<double(double, double)>;

/// Kernel of degree -1 over [0, X] x [0, Y], any signs, in polar coordinates about the singularity:
/// ∫ f(theta)/s * s ds = f(theta) times the distance to the boundary.
double over_quadrant(const Kernel& kernel, double x, double y) {
    if (x == 0 || y == 0) return 0;
    auto ray = [&](double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        const double length = std::min(std::abs(x) / c, std::abs(y) / s);
        return kernel(std::copysign(c, x), std::copysign(s, y)) * length;
    };
    const double corner = std::atan2(std::abs(y), std::abs(x));
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    const double sum =
        Rule::integrate(ray, 0, corner, 8, 1e-13) + Rule::integrate(ray, corner, pi / 2, 8, 1e-13);
    return sum * (x > 0 ? 1 : -1) * (y > 0 ? 1 : -1);
}

/// Over the rectangle at (x, y) from its centre: singular inside, so that the four rectangles that
/// the point makes with its corners are summed with their signs.
double near_integral(const Kernel& kernel, double x, double y) {
    const double right = x + width_x / 2, left = x - width_x / 2;
    const double upper = y + width_y / 2, lower = y - width_y / 2;
    return over_quadrant(kernel, right, upper) - over_quadrant(kernel, left, upper) -
           over_quadrant(kernel, right, lower) + over_quadrant(kernel, left, lower);
}

/// The same by a product rule, for points away from the rectangle.
double far_integral(const Kernel& kernel, double x, double y) {
    using Rule = boost::math::quadrature::gauss<double, 40>;
    return Rule::integrate(
        [&](double v) {
            return Rule::integrate([&](double u) { return kernel(x - u, y - v); }, -width_x / 2,
                                   width_x / 2);
        },
        -width_y / 2, width_y / 2);
}

struct Bodies {
    std::optional<Material> indenter;
    Material substrate;
};
const Bodies bodies[] = {{{}, {3, 0}},
                         {{}, {3, .3}},
                         {{}, {3, .5}},
                         {Material{7, .2}, {3, .5}},
                         {Material{2, .45}, {3, 0}},
                         {Material{3, .3}, {3, .3}}};

TEST(Influence, EqualsTheIntegralOfPointForces) {
    const double inside[][2] = {{0, 0}, {.1, -.2}, {.39, .64}, {.4, .3}, {-.4, -.65}};
    const double outside[][2] = {{.8, .3}, {-1.6, 0}, {0, 2.6}, {2.4, -3.9}, {-40, 13}};
    for (const auto& [indenter, substrate] : bodies) {
        const RectangleInfluence influence(MaterialPair(indenter, substrate), width_x, width_y);
        for (const bool near : {true, false})
            for (const auto& [x, y] : near ? inside : outside) {
                const auto k = influence.at(x, y);
                for (const auto term : all) {
                    auto kernel = [&, i = indenter, s = substrate](double u, double v) {
                        return point_force(i, s, u, v).*term;
                    };
                    const double expected =
                        near ? near_integral(kernel, x, y) : far_integral(kernel, x, y);
                    // quadrature to 1e-13 of zz(0), four logarithms of order one cancel
                    ASSERT_NEAR(k.*term, expected, 3e-13) << x << ' ' << y;
                }
                EXPECT_EQ(k.yx(), k.xy);
            }
    }
}

TEST(Influence, SquareUnderItsOwnTraction) {
    // Love (1929): at the centre of a square of side c, zz = (1-nu)/G * 2 c/pi asinh(1)
    const Material rubber{3, .5};
    const RectangleInfluence square(MaterialPair({}, rubber), .2, .2);
    EXPECT_NEAR(square.at(0, 0).zz, .5 / 1. * 2 * .2 / pi * std::asinh(1.), 1e-15);
    EXPECT_NEAR(square.at(0, 0).xx, square.at(0, 0).yy, 1e-16);
    for (const auto term :
         {&InfluenceCoefficients::xy, &InfluenceCoefficients::xz, &InfluenceCoefficients::yz})
        EXPECT_EQ(square.at(0, 0).*term, 0);
}

TEST(Influence, FarAwayAPointForce) {
    for (const auto& [indenter, substrate] : bodies) {
        const RectangleInfluence influence(MaterialPair(indenter, substrate), width_x, width_y);
        for (const double angle : {.3, 1.2, 2.2, 4.}) {
            const double r = 200, x = r * std::cos(angle), y = r * std::sin(angle);
            const auto k = influence.at(x, y);
            const auto point = point_force(indenter, substrate, x, y);
            for (const auto term : all) {
                // next order of the expansion: (width/r)^2/8 times second derivatives of order ten;
                // cancellation of the corners: 1e-16 r/width
                const double scale = width_x * width_y * point.zz;
                EXPECT_NEAR(k.*term / scale, point.*term / point.zz, 1e-4) << angle;
            }
        }
    }
}

TEST(Influence, ReciprocityAndMirrors) {
    const RectangleInfluence k(MaterialPair(Material{7, .2}, {3, .4}), width_x, width_y);
    constexpr double rounding = 1e-15;
    for (const auto& [x, y] : {std::pair{.1, .2}, std::pair{1.6, -2.6}, std::pair{-.8, 0.}}) {
        const auto here = k.at(x, y), there = k.at(-x, -y), mirrored = k.at(-x, y);
        for (const auto term : {&InfluenceCoefficients::xx, &InfluenceCoefficients::xy,
                                &InfluenceCoefficients::yy, &InfluenceCoefficients::zz})
            EXPECT_NEAR(here.*term, there.*term, rounding);
        // Betti: u_x here per traction z there = u_z there per traction x here
        EXPECT_NEAR(here.xz, there.zx(), rounding);
        EXPECT_NEAR(here.yz, there.zy(), rounding);
        EXPECT_NEAR(mirrored.xx, here.xx, rounding);
        EXPECT_NEAR(mirrored.xy, -here.xy, rounding);
        EXPECT_NEAR(mirrored.xz, -here.xz, rounding);
        EXPECT_NEAR(mirrored.yz, here.yz, rounding);
    }
}

TEST(Influence, TurnedByARightAngle) {
    const MaterialPair materials(Material{7, .2}, {3, .4});
    const RectangleInfluence lying(materials, width_x, width_y),
        standing(materials, width_y, width_x);
    constexpr double rounding = 1e-15;
    for (const auto& [x, y] : {std::pair{.1, .2}, std::pair{1.6, -2.6}, std::pair{-.8, .4}}) {
        // (x, y) -> (-y, x): e_x -> e_y, e_y -> -e_x
        const auto a = lying.at(x, y), b = standing.at(-y, x);
        EXPECT_NEAR(b.yy, a.xx, rounding);
        EXPECT_NEAR(b.xx, a.yy, rounding);
        EXPECT_NEAR(b.xy, -a.xy, rounding);
        EXPECT_NEAR(b.yz, a.xz, rounding);
        EXPECT_NEAR(b.xz, -a.yz, rounding);
        EXPECT_NEAR(b.zy(), a.zx(), rounding);
        EXPECT_NEAR(b.zz, a.zz, rounding);
    }
}

TEST(Influence, PartsAddUpToTheWhole) {
    const MaterialPair materials({}, {3, .3});
    const RectangleInfluence whole(materials, width_x, width_y);
    const RectangleInfluence part(materials, width_x / 4, width_y / 2);
    for (const auto& [x, y] : {std::pair{.05, .2}, std::pair{1.6, -2.6}}) {
        for (const auto term : all) {
            double sum = 0;
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 2; ++j)
                    sum += part.at(x - (i - 1.5) * width_x / 4, y - (j - .5) * width_y / 2).*term;
            EXPECT_NEAR(sum, whole.at(x, y).*term, 1e-14);
        }
    }
}

}  // namespace
}  // namespace tricontact::influence_test
