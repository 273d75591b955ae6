// Layers on an elastic half-space, and many of them, against what they are when materials coincide
// or differ without limit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "bem/influence.h"
#include "bem/model.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "mdr/layer_model.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::elastic_ground_test {
namespace {

using bem::InfluenceCoefficients;
using bem::LayerInfluence;
using contact::Case;
using contact::Material;
using theory::LayerBase;
using theory::LayerStack;

constexpr double h = .15, b = 1;

/// Largest difference of two bodies' coefficients, over the cell's own.
template <class One, class Other>
double difference(const One& one, const Other& other) {
    using K = InfluenceCoefficients;
    double worst = 0;
    for (const auto& [x, y] : {std::pair(0., 0.), {h, 0.}, {-.45, .6}, {1.65, -2.1}, {4.2, 3.}}) {
        const K a = one.at(x, y), c = other.at(x, y);
        for (double K::*value : {&K::xx, &K::xy, &K::yy, &K::xz, &K::yz, &K::zz})
            worst = std::max(worst, std::abs(a.*value - c.*value));
    }
    return worst / other.at(0, 0).zz;
}

LayerInfluence influence(const LayerStack& stack, const std::optional<Material>& indenter = {}) {
    return LayerInfluence(stack, indenter, h, h, 6);
}

// Boussinesq, Cerruti and Love: to what the layers' table promises.
TEST(BemElasticGround, OfTheLayersMaterialIsTheHalfSpace) {
    for (const double nu : {-.4, 0., .3, .5}) {
        const Material m{2.3, nu};
        const bem::RectangleInfluence half_space({{}, m}, h, h);
        EXPECT_LT(difference(influence({{{m, b}}, LayerBase::bonded, m}), half_space), 1e-8) << nu;
        EXPECT_LT(difference(influence({{{m, .4}, {m, 2}, {m, .1}, {m, 1}}, LayerBase::bonded, m}),
                             half_space),
                  1e-8)
            << nu;
        const Material other{7, .2};
        EXPECT_LT(difference(influence({{{m, b}}, LayerBase::bonded, m}, other),
                             bem::RectangleInfluence({other, m}, h, h)),
                  1e-8);
    }
}

TEST(BemElasticGround, EqualLayersAreOne) {
    for (const double nu : {-.4, .3, .5}) {
        const Material m{2.3, nu};
        for (const auto& ground : {std::optional<Material>(), std::optional(Material{9, .1})}) {
            const auto one = influence({{{m, b}}, LayerBase::bonded, ground});
            const LayerStack many{
                {{m, .3}, {m, .3}, {m, .1}, {m, .2}, {m, .1}}, LayerBase::bonded, ground};
            EXPECT_LT(difference(influence(many), one), 1e-8) << nu;
        }
    }
}

// What a stiff ground still gives is of the order of its compliance.
TEST(BemElasticGround, StiffensToTheRigidOne) {
    for (const double nu : {.3, .5}) {
        const Material m{2.3, nu};
        const auto rigid = influence({{{m, b}}, LayerBase::bonded, {}});
        const auto error = [&](double ratio) {
            const Material ground{ratio * m.young, .25};
            return difference(influence({{{m, b}}, LayerBase::bonded, ground}), rigid);
        };
        const double coarse = error(1e2), middle = error(1e3), fine = error(1e4);
        EXPECT_NEAR(std::log10(coarse / middle), 1, .05) << nu;
        EXPECT_NEAR(std::log10(middle / fine), 1, .05) << nu;
        EXPECT_LT(fine, 1e-4) << nu;
    }
}

// Without a ground the layer is a plate loaded on one face: half the sum of what equal and opposite
// loads on both faces do. Timoshenko and Goodier (1970), art. 24; y = k b/2:
//   C33, C11 = (1 - nu)/(2 G k) [(cosh 2y -+ 1)/(sinh 2y + 2y) + (cosh 2y +- 1)/(sinh 2y - 2y)].
TEST(BemElasticGround, SoftensToNone) {
    const double nu = .3, g = 1.7, k = 1.3;
    const Material m{2 * (1 + nu) * g, nu};
    const double y2 = k * b, unit = (1 - nu) / (2 * g * k);
    const double even = std::sinh(y2) + y2, odd = std::sinh(y2) - y2, cosh = std::cosh(y2);
    const double normal = unit * ((cosh - 1) / even + (cosh + 1) / odd);
    const double along = unit * ((cosh + 1) / even + (cosh - 1) / odd);
    const double across = 1 / (g * k * std::tanh(y2));
    const auto error = [&](double ratio) {
        const auto c = theory::surface_compliance(
            {{{m, b}}, LayerBase::bonded, Material{ratio * m.young, .4}}, k);
        return std::max({std::abs(c.normal / normal - 1), std::abs(c.along / along - 1),
                         std::abs(c.across / across - 1)});
    };
    // The error is the ground's modulus over the plate's stiffness.
    EXPECT_NEAR(std::log10(error(1e-3) / error(1e-4)), 1, .05);
    EXPECT_NEAR(std::log10(error(1e-4) / error(1e-5)), 1, .05);
    EXPECT_LT(error(1e-8), 1e-6);
}

Case pressed_case() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 3e-3;
    c.layer.base = Case::Base::half_space;
    c.layer.ground = c.substrate;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .5;
    c.of<contact::Cells>().per_radius = 16;
    return c;
}

contact::Scales pressed(contact::Model& model, const Case& c) {
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    model.advance(step);
    return model.scales();
}

TEST(BemElasticGround, HertzContactOnOneMaterial) {
    Case c = pressed_case();
    const auto layer = bem::make_model(c, 1, bem::Body::layer);
    const auto half_space = bem::make_model(c, 1);
    const auto a = pressed(*layer, c), e = pressed(*half_space, c);
    // Coefficients agree to 1e-8; the solvers stop at 1e-8 of d.
    EXPECT_NEAR(a.indentation / e.indentation, 1, 1e-6);
    EXPECT_NEAR(a.contact_radius / e.contact_radius, 1, 1e-6);
    EXPECT_NEAR(a.peak_pressure / e.peak_pressure, 1, 1e-6);
    EXPECT_NEAR(a.unit_shift / e.unit_shift, 1, 1e-6);
    const auto hertz = contact::half_space_scales(c);
    EXPECT_NEAR(a.indentation / hertz.indentation, 1, 2e-3);  // 16 cells in a
    // The springs of mdr-layer, coupled by nothing.
    const auto mdr = mdr::make_layer_model(c);
    const auto line = pressed(*mdr, c);
    EXPECT_NEAR(line.indentation / hertz.indentation, 1, 1e-4);  // 100 elements in a
    EXPECT_NEAR(line.contact_radius / hertz.contact_radius, 1, 1e-4);
    EXPECT_NEAR(line.unit_shift / hertz.unit_shift, 1, 1e-4);
}

// Two discretisations of different theories: squares on the surface, elements on a line.
TEST(BemElasticGround, TwoModelsAgree) {
    for (const auto& [young, nu] : {std::pair(.52e6, .3), {52e6, .3}, {5.2e9, .2}}) {
        Case c = pressed_case();
        c.layer.ground = Material{young, nu};
        const auto model = bem::make_model(c, 1, bem::Body::layer);
        const auto surface = pressed(*model, c);
        // A stiff layer on a soft ground bends: the largest pressure is not at the centre.
        const auto pressure = model->surface().normal_traction;
        const double centre = pressure[pressure.size() / 2];
        const auto line = pressed(*mdr::make_layer_model(c), c);
        const auto place = ::testing::Message() << "E of the ground " << young;
        EXPECT_NEAR(surface.indentation / line.indentation, 1, 3e-3) << place;
        EXPECT_NEAR(centre / line.peak_pressure, 1, 3e-3) << place;
        EXPECT_NEAR(surface.unit_shift / line.unit_shift, 1, 3e-3) << place;
    }
}

TEST(CaseLayers, AreRefusedWithoutThicknessOrGround) {
    const auto message = [](const Case& c) -> std::string {
        try {
            theory::layers_of("bem-layer", c);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no error";
    };
    Case c = pressed_case();
    EXPECT_EQ(message(c), "no error");
    c.layer.ground.reset();
    EXPECT_EQ(message(c),
              "bem-layer: substrate.base = \"half-space\" without [ground]; give its young and "
              "poisson");
    c.layer.thickness.reset();
    EXPECT_EQ(message(c),
              "bem-layer: substrate.thickness is missing; give the thickness of the layer");
}

}  // namespace
}  // namespace tricontact::elastic_ground_test
