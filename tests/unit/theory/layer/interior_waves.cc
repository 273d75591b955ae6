#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "theory/layer/layer_stack.h"

namespace tricontact::theory::interior_waves_test {
namespace {

using contact::Material;

constexpr double g = 3e6, b = 4e-3;  // no scale is 1

Material material(double nu) {
    return {2 * g * (1 + nu), nu};
}

// Rounding of a few dozen steps.
constexpr double rounding = 1e-13;

TEST(InteriorWaves, BelowAHalfSpaceTheyAreItsClosedForms) {
    for (const double nu : {0., .3, .5})
        for (const double k : {20., 300., 4e3}) {
            const LayerStack stack{{{material(nu), b}}, LayerBase::bonded, material(nu)};
            const std::array depths{0., 1e-4, 1.3e-3, b};
            const auto waves = interior_waves(stack, k, depths);
            for (std::size_t i = 0; i < depths.size(); ++i) {
                const double x = k * depths[i], decay = std::exp(-x), u = decay / (2 * g * k);
                const auto& p = waves[i].pressed;
                const double unit = 1 / (g * k);
                EXPECT_NEAR(p.u_z, u * (2 * (1 - nu) + x), rounding * unit);
                EXPECT_NEAR(p.u_along, -u * (1 - 2 * nu - x), rounding * unit);
                EXPECT_NEAR(p.sigma_z, -(1 + x) * decay, rounding);
                EXPECT_NEAR(p.tau, -x * decay, rounding);
                EXPECT_NEAR(p.sigma_along, -(1 - x) * decay, rounding);
                EXPECT_NEAR(p.sigma_across, -2 * nu * decay, rounding);
                EXPECT_NEAR(waves[i].across_u, decay / (g * k), rounding * unit);
                EXPECT_NEAR(waves[i].across_tau, -decay, rounding);
                EXPECT_NEAR(waves[i].across_shear, -decay, rounding);
            }
        }
}

TEST(InteriorWaves, SurfaceIsThatOfTheClosedForms) {
    for (const LayerBase base : {LayerBase::bonded, LayerBase::frictionless})
        for (const double nu : {0., .3, .5})
            for (const double x : {0.05, 0.7, 3., 30.}) {
                const double k = x / b, unit = 1 / (g * k);
                const LayerStack stack{{{material(nu), b}}, base, {}};
                const auto surface = interior_waves(stack, k, std::array{0.}).front();
                const auto c = layer_compliance({material(nu), b, base}, k);
                const double scale = 1e-12 * std::max(unit, std::abs(c.along));
                EXPECT_NEAR(surface.pressed.u_z, c.normal, scale);
                EXPECT_NEAR(surface.sheared.u_along, c.along, scale);
                EXPECT_NEAR(surface.across_u, c.across, scale);
                EXPECT_NEAR(surface.sheared.u_z, c.coupling, scale);
                EXPECT_NEAR(surface.pressed.u_along, -c.coupling, scale);
                EXPECT_NEAR(surface.pressed.sigma_z, -1, rounding);
                EXPECT_NEAR(surface.pressed.tau, 0, rounding);
                EXPECT_NEAR(surface.sheared.tau, -1, rounding);
                EXPECT_NEAR(surface.sheared.sigma_z, 0, rounding);
                EXPECT_NEAR(surface.across_tau, -1, rounding);
            }
}

TEST(InteriorWaves, TheBaseHolds) {
    for (const double nu : {.2, .5}) {
        const double k = 400;
        const auto base = [&](LayerBase kind) {
            return interior_waves({{{material(nu), b}}, kind, {}}, k, std::array{b}).front();
        };
        const InteriorWaves bonded = base(LayerBase::bonded),
                            glides = base(LayerBase::frictionless);
        const double unit = rounding / (g * k);
        for (const double u :
             {bonded.pressed.u_z, bonded.pressed.u_along, bonded.sheared.u_z,
              bonded.sheared.u_along, bonded.across_u, glides.pressed.u_z, glides.sheared.u_z})
            EXPECT_NEAR(u, 0, unit);
        for (const double tau : {glides.pressed.tau, glides.sheared.tau, glides.across_tau})
            EXPECT_NEAR(tau, 0, rounding);
        EXPECT_GT(std::abs(bonded.pressed.sigma_z), 0.1);  // not zero for want of a wave
    }
}

// Displacements and tractions pass an interface, stresses along it jump by the moduli.
TEST(InteriorWaves, NothingOpensBetweenLayers) {
    const Material soft = material(.5), hard{4e7, .2};
    const LayerStack stack{{{hard, 1e-3}, {soft, 3e-3}}, LayerBase::bonded, {}};
    const double k = 500, step = 1e-10;
    const auto waves = interior_waves(stack, k, std::array{1e-3, 1e-3 + step});
    const auto &above = waves[0], &below = waves[1];
    const double near = 10 * k * step;  // first order in the step
    for (const auto wave : {&InteriorWaves::pressed, &InteriorWaves::sheared}) {
        EXPECT_NEAR((above.*wave).u_z, (below.*wave).u_z, near / (g * k));
        EXPECT_NEAR((above.*wave).u_along, (below.*wave).u_along, near / (g * k));
        EXPECT_NEAR((above.*wave).tau, (below.*wave).tau, near);
        EXPECT_NEAR((above.*wave).sigma_z, (below.*wave).sigma_z, near);
    }
    EXPECT_NEAR(above.across_shear / below.across_shear,
                hard.shear_modulus() / soft.shear_modulus(), 1e-5);
}

// What is deep on the scale of the wave is not seen, and no exponential overflows.
TEST(InteriorWaves, ShortWavesEndInTheTopLayer) {
    const LayerStack stack{{{material(.4), b}}, LayerBase::bonded, {}};
    const double k = 1e3 / b;
    const auto waves = interior_waves(stack, k, std::array{0., 0.02 * b, 0.5 * b, b});
    EXPECT_NEAR(waves[1].pressed.sigma_z, -(1 + 20) * std::exp(-20), rounding);
    EXPECT_EQ(waves[2].pressed.sigma_z, 0);
    EXPECT_EQ(waves[3].sheared.tau, 0);
}

}  // namespace
}  // namespace tricontact::theory::interior_waves_test
