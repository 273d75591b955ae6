#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/compliances/interior.h"
#include "theory/half_space_interior.h"
#include "theory/hertz.h"

namespace tricontact::theory::axisymmetric_interior_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double a = 3e-3, p0 = 2e5, young = 7e6;

InteriorResponse hertz(double nu, double x, double y, double z) {
    const auto line_load = [](double t) { return pi / 2 * p0 * (a - t) * (a + t) / a; };
    return axisymmetric_interior({young, nu}, line_load, a, x * a, y * a, z * a);
}

std::array<double, 6> stress_of(const InteriorResponse& response, double friction) {
    std::array<double, 6> s{};
    for (int k = 0; k < 6; ++k)
        s[k] = (response.stress[k][2] + friction * response.stress[k][0]) / p0;
    return s;
}

// Johnson (1985), eq. 3.45.
TEST(AxisymmetricInterior, AxisIsHubers) {
    for (const double nu : {0., .3, .5})
        for (const double z : {.05, .3, .48, 1., 2.5, 20.}) {
            const auto s = stress_of(hertz(nu, 0, 0, z), 0);
            const double axial = -1 / (1 + z * z);
            const double radial = -(1 + nu) * (1 - z * std::atan(1 / z)) - axial / 2;
            EXPECT_NEAR(s[2], axial, 1e-11);
            EXPECT_NEAR(s[0], radial, 1e-11);
            EXPECT_NEAR(s[1], radial, 1e-11);
            for (const int c : {3, 4, 5}) EXPECT_NEAR(s[c], 0, 1e-12);
        }
}

// Huber (1904) off the axis, as in Timoshenko and Goodier, with u the larger root of
// r^2/(a^2 + u) + z^2/u = 1: sigma_z = -p0 (z/sqrt u)^3 a^2 u/(u^2 + a^2 z^2),
// tau_rz = -p0 r z^2/(u^2 + a^2 z^2) a^2 sqrt(u)/(a^2 + u).
TEST(AxisymmetricInterior, OffTheAxisIsHubers) {
    for (const double r : {.2, .7, 1., 1.6})
        for (const double z : {.1, .5, 1.3}) {
            const auto s = stress_of(hertz(.3, r * .6, r * .8, z), 0);
            const double sum = r * r + z * z - 1, u = (sum + std::hypot(sum, 2 * z)) / 2;
            const double root = std::sqrt(u), common = 1 / (u * u + z * z);
            EXPECT_NEAR(s[2], -std::pow(z / root, 3) * u * common, 1e-10);
            const double shear = -r * z * z * common * root / (1 + u);
            EXPECT_NEAR(s[5], .6 * shear, 1e-10);
            EXPECT_NEAR(s[4], .8 * shear, 1e-10);
        }
}

// Johnson (1985), section 4.2: nu = 0.3, von Mises 0.62 p0 at 0.48 a; tau 0.31 p0 there.
TEST(AxisymmetricInterior, WherePublishedStressesPeak) {
    double largest = 0, place = 0, shear = 0;
    for (double z = .2; z < 1; z += 2e-3) {
        const auto s = stress_of(hertz(.3, 0, 0, z), 0);
        shear = std::max(shear, std::abs(s[2] - s[0]) / 2);
        if (contact::von_mises(s) <= largest) continue;
        largest = contact::von_mises(s);
        place = z;
    }
    EXPECT_NEAR(largest, .62, .005);  // as printed
    EXPECT_NEAR(place, .48, .005);
    EXPECT_NEAR(shear, .31, .005);
}

// Hamilton and Goodman (1966), Johnson (1985), eq. 7.29: behind a sliding sphere the surface is
// pulled by (1 - 2 nu)/3 + mu pi (4 + nu)/8. The limit is reached with the root of the depth.
TEST(AxisymmetricInterior, TensionBehindASlidingSphere) {
    const double mu = .25;
    for (const double nu : {.3, .5}) {
        const auto at = [&](double z) { return stress_of(hertz(nu, -1, 0, z), mu)[0]; };
        const double due = (1 - 2 * nu) / 3 + mu * pi * (4 + nu) / 8;
        const double coarse = std::abs(at(4e-4) - due), fine = std::abs(at(1e-4) - due);
        EXPECT_NEAR(coarse / fine, 2, .05);
        EXPECT_LT(fine, .05);
        EXPECT_NEAR(2 * at(1e-4) - at(4e-4), due, 2e-3);  // extrapolated in the root
    }
}

// Extrapolated to the surface from two depths: what is left is of second order in the depth.
TEST(AxisymmetricInterior, SurfaceCarriesTheTractions) {
    constexpr double depth = 1e-3;
    const InteriorResponse near = hertz(.4, .3, -.2, depth), far = hertz(.4, .3, -.2, 2 * depth);
    const double p = p0 * std::sqrt(1 - .13);
    const auto stress = [&](int c, int load) {
        return (2 * near.stress[c][load] - far.stress[c][load]) / p;
    };
    // z is into the body: the traction on it is -sigma_xz.
    EXPECT_NEAR(stress(2, 2), -1, 1e-5);
    EXPECT_NEAR(stress(5, 0), -1, 1e-5);
    EXPECT_NEAR(stress(4, 1), -1, 1e-5);
    EXPECT_NEAR(stress(5, 2), 0, 1e-5);
    const double effective = young / (1 - .16), d = pi * p0 * a / (2 * effective);
    EXPECT_NEAR(2 * near.displacement[2][2] - far.displacement[2][2], d * (1 - .13 / 2), 1e-5 * d);
}

// div sigma = 0 and Hooke's law with strains by central differences of the step h: what is left
// falls as h^2.
TEST(AxisymmetricInterior, EquilibriumAndHookesLaw) {
    constexpr std::array<std::array<int, 3>, 3> index = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};
    const double nu = .5, x = .4, y = -.7, z = .35, shear_modulus = young / (2 * (1 + nu));
    std::vector<double> residual;
    for (const double h : {.02, .01}) {
        std::array<std::array<InteriorResponse, 2>, 3> at;
        for (int d = 0; d < 3; ++d)
            for (int side = 0; side < 2; ++side) {
                std::array<double, 3> place{x, y, z};
                place[d] += side == 0 ? -h : h;
                at[d][side] = hertz(nu, place[0], place[1], place[2]);
            }
        const auto centre = hertz(nu, x, y, z);
        double worst = 0;
        for (int load = 0; load < 3; ++load) {
            const auto slope = [&](int of, int by) {
                return (at[by][1].displacement[of][load] - at[by][0].displacement[of][load]) /
                       (2 * h * a);
            };
            const auto& s = centre.stress;
            const double mean = (s[0][load] + s[1][load] + s[2][load]) / 3;
            for (int i = 0; i < 3; ++i) {
                double divergence = 0;
                for (int j = 0; j < 3; ++j) {
                    const int k = index[i][j];
                    divergence += (at[j][1].stress[k][load] - at[j][0].stress[k][load]) / (2 * h);
                    const double deviator = s[k][load] - (i == j ? mean : 0);
                    worst = std::max(
                        worst, std::abs(deviator - shear_modulus * (slope(i, j) + slope(j, i))));
                }
                worst = std::max(worst, std::abs(divergence));
            }
        }
        residual.push_back(worst / p0);
    }
    EXPECT_LT(residual[1], 5e-3);
    EXPECT_NEAR(residual[0] / residual[1], 4, .2);
}

}  // namespace
}  // namespace tricontact::theory::axisymmetric_interior_test
