#include "bem/interior_influence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bem/influence.h"

namespace tricontact::bem::interior_influence_test {
namespace {

using contact::Material;
using theory::InteriorResponse;
using theory::LayerBase;
using theory::LayerStack;

constexpr double b = 4e-3, g = 3e6;
constexpr contact::Vector2 widths{1e-3, .6e-3};

Material material(double nu) {
    return {2 * g * (1 + nu), nu};
}

InteriorBody half_space(double nu) {
    return InteriorBody(material(nu));
}
InteriorBody layers(double nu, LayerBase base = LayerBase::bonded) {
    return InteriorBody(LayerStack{{{material(nu), b}}, base, {}});
}
InteriorBody two_layers() {
    return InteriorBody(LayerStack{{{material(.5), b}, {{5e7, .2}, b / 2}}, LayerBase::bonded, {}});
}
InteriorBody on_ground() {
    return InteriorBody(LayerStack{{{material(.3), b}}, LayerBase::bonded, Material{4e7, .1}});
}

constexpr std::array<std::array<int, 3>, 3> index = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};

/// Largest violation, over unit traction, of div sigma = 0 and of Hooke's law by central
/// differences over h at a point inside.
double residual(const InteriorBody& body, double h) {
    const double x = .8e-3, y = -1.8e-3, z = 1.4e-3;
    const InteriorInfluence influence(body, widths, {z - h, z, z + h}, 5e-3);
    const std::array<std::array<InteriorResponse, 2>, 3> at = {
        {{influence.at(1, x - h, y), influence.at(1, x + h, y)},
         {influence.at(1, x, y - h), influence.at(1, x, y + h)},
         {influence.at(0, x, y), influence.at(2, x, y)}}};
    const auto s = influence.at(1, x, y).stress;
    double worst = 0;
    for (int load = 0; load < 3; ++load) {
        const auto slope = [&](int of, int by) {
            return (at[by][1].displacement[of][load] - at[by][0].displacement[of][load]) / (2 * h);
        };
        const double mean = (s[0][load] + s[1][load] + s[2][load]) / 3;
        const double dilation = (slope(0, 0) + slope(1, 1) + slope(2, 2)) / 3;
        for (int i = 0; i < 3; ++i) {
            double divergence = 0;
            for (int j = 0; j < 3; ++j) {
                const int k = index[i][j];
                divergence += (at[j][1].stress[k][load] - at[j][0].stress[k][load]) / (2 * h);
                const double stress = s[k][load] - (i == j ? mean : 0);
                const double strain = slope(i, j) + slope(j, i) - (i == j ? 2 * dilation : 0);
                worst = std::max(worst, std::abs(stress - g * strain));
            }
            worst = std::max(worst, std::abs(divergence) * widths[0]);
        }
        const double nu = body.material.poisson;  // 3 K eps = mean stress, also at nu = 1/2
        const double volumetric = (1 - 2 * nu) * mean - 2 * g * (1 + nu) * dilation;
        worst = std::max(worst, std::abs(volumetric));
    }
    return worst;
}

void expect_equilibrium(const InteriorBody& body) {
    const double coarse = residual(body, .1e-3), fine = residual(body, .05e-3);
    EXPECT_LT(fine, 1e-4);
    EXPECT_NEAR(coarse / fine, 4, .2);  // of central differences
}

TEST(InteriorInfluence, EquilibriumAndHookesLawInAHalfSpace) {
    for (const double nu : {-.2, .3, .5}) expect_equilibrium(half_space(nu));
}

TEST(InteriorInfluence, EquilibriumAndHookesLawInALayer) {
    for (const double nu : {.3, .5}) expect_equilibrium(layers(nu));
}

TEST(InteriorInfluence, EquilibriumAndHookesLawInAGlidingLayer) {
    expect_equilibrium(layers(.4, LayerBase::frictionless));
}

TEST(InteriorInfluence, EquilibriumAndHookesLawInLayersOnLayersAndOnGround) {
    expect_equilibrium(two_layers());
    expect_equilibrium(on_ground());
}

TEST(InteriorInfluence, SurfaceCarriesTheTractionsOfTheRectangleAlone) {
    for (const InteriorBody& body : {half_space(.2), layers(.5), two_layers()}) {
        const InteriorInfluence influence(body, widths, {0}, 5e-3);
        const auto inside = influence.at(0, .3e-3, -.2e-3), outside = influence.at(0, .6e-3, 1e-3);
        for (int load = 0; load < 3; ++load)
            for (const auto& [c, carried] : {std::pair(2, 2), std::pair(4, 1), std::pair(5, 0)}) {
                EXPECT_NEAR(inside.stress[c][load], load == carried ? -1 : 0, 1e-9);
                EXPECT_NEAR(outside.stress[c][load], 0, 1e-9);
            }
    }
}

// The surface's own coefficients, by other formulas.
TEST(InteriorInfluence, SurfaceMovesAsTheInfluenceCoefficientsSay) {
    const double x = 1.3e-3, y = .9e-3;
    const auto compare = [&](const InteriorBody& body, const InfluenceCoefficients& due) {
        const auto u = InteriorInfluence(body, widths, {0}, 5e-3).at(0, x, y).displacement;
        const double near = 1e-8 * due.zz;
        EXPECT_NEAR(u[0][0], due.xx, near);
        EXPECT_NEAR(u[1][1], due.yy, near);
        EXPECT_NEAR(u[0][1], due.xy, near);
        EXPECT_NEAR(u[1][0], due.xy, near);
        EXPECT_NEAR(u[2][2], due.zz, near);
        EXPECT_NEAR(u[0][2], due.xz, near);
        EXPECT_NEAR(u[1][2], due.yz, near);
        EXPECT_NEAR(u[2][0], due.zx(), near);
        EXPECT_NEAR(u[2][1], due.zy(), near);
    };
    compare(half_space(.3), RectangleInfluence({{}, material(.3)}, widths[0], widths[1]).at(x, y));
    for (const InteriorBody& body : {layers(.5), layers(.2, LayerBase::frictionless), on_ground()})
        compare(body, LayerInfluence(*body.layers, {}, widths[0], widths[1], 5e-3).at(x, y));
}

// u = 0 on a bonded base; no normal displacement and no shear on a gliding one.
TEST(InteriorInfluence, TheBaseHolds) {
    for (const double nu : {.3, .5}) {
        const double unit = widths[0] / g;
        const InteriorInfluence bonded(layers(nu), widths, {b}, 9e-3),
            glides(layers(nu, LayerBase::frictionless), widths, {b}, 9e-3);
        for (const double x : {.1e-3, 2e-3, 8e-3}) {
            const auto held = bonded.at(0, x, .3e-3), free = glides.at(0, x, .3e-3);
            for (int load = 0; load < 3; ++load) {
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(held.displacement[c][load], 0, 1e-8 * unit);
                EXPECT_NEAR(free.displacement[2][load], 0, 1e-8 * unit);
                for (const int c : {4, 5}) EXPECT_NEAR(free.stress[c][load], 0, 1e-8);
            }
            EXPECT_GT(std::abs(held.stress[2][2]), 1e-5);
        }
    }
}

// Far away the rectangle is a point force: Boussinesq's sigma_z = -3 P z^3/(2 pi r^5) and

// CONTACT's example subsurf (examples/subsurf.ref_out): a unit square under p = 1, then under a
// traction of 0.999 along x as well, nu = 0.28; three printed digits, its points 1e-4 aside.
TEST(InteriorInfluence, BelowTheSquareOfTheProgramContact) {
    const InteriorInfluence below(half_space(.28), {1, 1}, {0, .1, .4, 1.25}, 5);
    constexpr double printed = 6e-4;
    const auto axis = below.at(0, 1e-5, 1e-5).stress;
    EXPECT_NEAR(axis[0][2], -.780, printed);
    EXPECT_NEAR((axis[0][2] + axis[1][2] + axis[2][2]) / 3, -.853, printed);
    const auto deep = below.at(2, 1e-5, 1e-5).stress;
    EXPECT_NEAR(deep[0][2] - deep[2][2], .665, printed);  // von Mises on the axis, largest there
    EXPECT_NEAR(below.at(3, 1e-5, 1e-5).stress[0][2], .008, printed);  // largest principal stress
    const auto ahead = [&](std::size_t level, int component) {
        const auto s = below.at(level, .4, 0).stress;
        return s[component][2] + .999 * s[component][0];
    };
    EXPECT_NEAR(ahead(0, 0), -2.044, 2 * printed);  // grows towards the edge, 1e-4 aside there
    EXPECT_NEAR(ahead(0, 1), -.966, printed);
    EXPECT_NEAR(ahead(1, 2), -1.058, printed);
}

// Cerruti's -3 Q x z^2/(2 pi r^5); the next term is (width/r)^2.
TEST(InteriorInfluence, FarAwayItIsAPointForce) {
    const double x = 30e-3, y = 20e-3, z = 40e-3, r = std::sqrt(x * x + y * y + z * z);
    const auto s = InteriorInfluence(half_space(.4), widths, {z}, 1).at(0, x, y).stress[2];
    const double unit = 3 * widths[0] * widths[1] * z * z / (2 * std::numbers::pi * std::pow(r, 5));
    EXPECT_NEAR(s[2], -unit * z, 1e-3 * unit * z);
    EXPECT_NEAR(s[0], -unit * x, 1e-3 * unit * z);
    EXPECT_NEAR(s[1], -unit * y, 1e-3 * unit * z);
}

// Of a thick layer less and less is left: Hankel's kernel falls as (z/b)^2 or faster.
TEST(InteriorInfluence, AThickLayerIsTheHalfSpace) {
    std::vector<double> differences;
    for (const double thickness : {50e-3, 100e-3}) {
        const InteriorBody thick(LayerStack{{{material(.3), thickness}}, LayerBase::bonded, {}});
        const auto s = InteriorInfluence(thick, widths, {2e-3}, 5e-3).at(0, 1e-3, 1e-3).stress;
        const auto due =
            InteriorInfluence(half_space(.3), widths, {2e-3}, 5e-3).at(0, 1e-3, 1e-3).stress;
        double worst = 0;
        for (int c = 0; c < 6; ++c)
            for (int load = 0; load < 3; ++load)
                worst = std::max(worst, std::abs(s[c][load] - due[c][load]));
        differences.push_back(worst);
    }
    EXPECT_LT(differences[1], 1e-4);
    EXPECT_GT(differences[0] / differences[1], 3.6);  // tends to 4
}

}  // namespace
}  // namespace tricontact::bem::interior_influence_test
