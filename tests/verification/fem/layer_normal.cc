// Frictionless contact on the finite element layer against the exact layer (theory/elastic_layer).

#include <gtest/gtest.h>

#include <numbers>

#include "tests/verification/fem/rig.h"
#include "theory/hertz.h"

namespace tricontact::fem::fem_layer_normal_test {
namespace {

using contact::Case;
using contact::NormalControl;

struct Errors {
    double force, radius, peak;  // relative
    double inner_pressure;       // largest within 0.8 a, over p0
    double unit_shift;           // relative; 0 where the exact one does not exist
};

/// Pressed to the depth of the exact solution.
Errors pressed_errors(Case c) {
    const theory::LayerContact exact = exact_contact(c);
    c.load.normal_force.reset();
    c.load.indentation = exact.indentation;
    const auto model = make_layer_model(c);
    const contact::StepRecord record = press(*model, c);
    const contact::Scales scales = model->scales();
    const contact::Surface s = model->surface();
    double inner = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double r = std::hypot(s.node_x[i], s.node_y[i]);
        if (r < .8 * exact.contact_radius)
            inner = std::max(
                inner, std::abs(s.normal_traction[i] - exact.pressure(r)) / exact.centre_pressure);
    }
    return {record.normal_force / exact.normal_force - 1,
            scales.contact_radius / exact.contact_radius - 1,
            scales.peak_pressure / exact.centre_pressure - 1, inner,
            exact.unit_shift
                ? scales.unit_shift / (c.friction_coefficient() * *exact.unit_shift) - 1
                : 0};
}

struct Layer {
    const char* name;
    double nu;
    Case::Base base;
    double size;  // of the elements [m]
};

class FemLayer : public ::testing::TestWithParam<Layer> {
  protected:
    Case layer(double size) const {
        Case c = layer_case(size, GetParam().nu);
        c.layer.base = GetParam().base;
        return c;
    }
};

// a = 4.3 to 4.5 mm here. The pressures of nodes come from row sums, and at r < 0.8 a the square
// root's steep end is still a few nodes away.
TEST_P(FemLayer, MatchesTheExactLayer) {
    const Errors e = pressed_errors(layer(GetParam().size));
    EXPECT_LT(std::abs(e.force), 1e-3);  // what issue and users ask for
    EXPECT_LT(std::abs(e.radius), 3e-3);
    EXPECT_LT(std::abs(e.peak), 5e-3);
    EXPECT_LT(e.inner_pressure, 1e-2);
    EXPECT_LT(std::abs(e.unit_shift), 1e-3);
}

TEST_P(FemLayer, ForceConverges) {
    if (GetParam().base == Case::Base::frictionless)
        GTEST_SKIP() << "what is left at h = 0.7 mm is the influence of the sides";
    // The square root at the edge of the contact limits the order; whole elements enter one after
    // the other, so it is no clean power. Sizes of the same patch, errors above rounding.
    const double coarse = pressed_errors(layer(1.4e-3)).force,
                 fine = pressed_errors(layer(.7e-3)).force;
    EXPECT_GT(order(coarse, fine, 2), 1.3) << coarse << ' ' << fine;
}

INSTANTIATE_TEST_SUITE_P(
    Rig, FemLayer,
    ::testing::Values(Layer{"Incompressible", .5, Case::Base::bonded, .7e-3},
                      Layer{"AlmostIncompressible", .49, Case::Base::bonded, .7e-3},
                      Layer{"Compressible", .3, Case::Base::bonded, .7e-3},
                      Layer{"FrictionlessBase", .5, Case::Base::frictionless, .7e-3},
                      Layer{"CompressibleFrictionlessBase", .3, Case::Base::frictionless, .7e-3}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FemLayerNormal, TheRigsNumbers) {
    const Case c = layer_case(.7e-3);
    const auto model = make_layer_model(c);
    press(*model, c);
    const contact::Scales s = model->scales();
    // layer.md, rig 5.1.1; tolerances as above
    EXPECT_NEAR(s.contact_radius, 4.3638e-3, 3e-3 * 4.3638e-3);
    EXPECT_NEAR(s.indentation, .3229e-3, 1e-3 * .3229e-3);
    EXPECT_NEAR(s.peak_pressure, .5330e6, 5e-3 * .5330e6);
    EXPECT_NEAR(s.unit_shift, .37912e-3, 1e-3 * .37912e-3);
}

TEST(FemLayerNormal, ForceAndDepthAreInverse) {
    Case c = layer_case(1e-3);
    const auto by_force = make_layer_model(c);
    const double depth = press(*by_force, c).indentation;
    c.load.normal_force.reset();
    c.load.indentation = depth;
    const auto by_depth = make_layer_model(c);
    // both solve the same active set exactly; condition of the compliance times rounding
    EXPECT_NEAR(press(*by_depth, c).normal_force, 21.1, 21.1 * 1e-9);
}

TEST(FemLayerNormal, TwoEqualLayersAreOne) {
    Case c = layer_case(1e-3);
    const auto one = make_layer_model(c);
    const double depth = press(*one, c).indentation;
    c.layer.thickness = 3e-3;
    c.layer.lower = {{5e-3, c.substrate}};
    const auto two = make_layer_model(c);
    // other elements in depth; their error at h = 1 mm is 2e-3
    EXPECT_NEAR(press(*two, c).indentation, depth, 2e-3 * depth);
}

// Of the same elements above: their error is in none of the ratios.
TEST(FemLayerNormal, AStifferLayerBelowActsLikeTheGround) {
    Case c = layer_case(1.4e-3);
    const auto bonded = make_layer_model(c);
    const double depth = press(*bonded, c).indentation;
    c.layer.lower = {{8e-3, {5.2e10, .3}}};  // ten thousand times stiffer
    const auto on_stiff = make_layer_model(c);
    EXPECT_NEAR(press(*on_stiff, c).indentation, depth, 1e-3 * depth);
    c.layer.lower.front().material = {5.2e5, .5};  // ten times softer: it gives way
    const auto on_soft = make_layer_model(c);
    EXPECT_GT(press(*on_soft, c).indentation, 1.5 * depth);
}

}  // namespace
}  // namespace tricontact::fem::fem_layer_normal_test
