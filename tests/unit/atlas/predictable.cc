// What predict refuses, and what it says of models that leave something out.

#include "atlas/predictable.h"

#include <gtest/gtest.h>

#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"

namespace tricontact::atlas::predictable_test {
namespace {

using contact::Case;

Case layer() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .3;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .2;
    return c;
}

std::string refusal_of(const Case& c) {
    try {
        predictable_models(c);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Predictable, ALayerThatIsMappedStandsBesideItsHalfSpaces) {
    EXPECT_EQ(predictable_models(layer()), (std::vector<std::string>{"mdr", "bem", "bem-layer"}));
    EXPECT_TRUE(predict(layer(), "bem-layer").left_out.empty());
    for (const char* model : {"mdr", "bem"}) {
        const auto left_out = predict(layer(), model).left_out;
        ASSERT_EQ(left_out.size(), 1u);
        EXPECT_EQ(left_out.front(), "substrate.thickness: the substrate is a half-space");
    }
    Case half_space = layer();
    half_space.layer = {};
    EXPECT_EQ(predictable_models(half_space), (std::vector<std::string>{"mdr", "bem"}));
    EXPECT_TRUE(predict(half_space, "mdr").left_out.empty());
}

// Never a half-space in its place, unless asked for.
TEST(Predictable, ALayerThatIsNotMappedIsRefused) {
    Case wide = layer(), soft = layer(), uncoupled = layer(), glides = layer();
    wide.layer.width = .06;
    soft.indenter.material = contact::Material{10e6, .4};
    uncoupled.contact.coupling = false;
    glides.layer.base = Case::Base::frictionless;
    EXPECT_NE(refusal_of(wide).find("layers of finite width or depth"), std::string::npos);
    EXPECT_NE(refusal_of(soft).find("indenters on a layer that are not rigid"), std::string::npos);
    EXPECT_NE(refusal_of(uncoupled).find("layers without coupling"), std::string::npos);
    EXPECT_NE(refusal_of(glides).find("not bonded"), std::string::npos);
    EXPECT_NE(refusal_of(wide).find("mdr would leave the layer out"), std::string::npos);
    EXPECT_EQ(predict(wide, "mdr").left_out.size(), 1u);
}

// A strength has maps of the half-space; what has none is told by name.
TEST(Predictable, AShearStrengthOnAHalfSpace) {
    Case c = layer();
    c.friction = {.shear_strength = 1e5};
    EXPECT_NE(refusal_of(c).find("layers under a shear strength"), std::string::npos);
    c.layer = {};
    EXPECT_EQ(predictable_models(c), (std::vector<std::string>{"mdr", "bem"}));
    const Prediction maps = predict(c, "bem"), springs = predict(c, "mdr");
    const auto* kappa = maps.find(comparisons::quantities::kappa);
    ASSERT_TRUE(kappa);
    EXPECT_LT(kappa->value.value, .85);
    EXPECT_EQ(maps.rests_on.back(), "sphere_half_space_strength");
    EXPECT_NEAR(springs.find(comparisons::quantities::kappa)->value.value, 1.2732395447, 1e-9);
    c.load.tangential_ratio = .95;  // ratchets
    ASSERT_EQ(predict(c, "bem").gaps.size(), 1u);
    EXPECT_EQ(predict(c, "bem").gaps.front(),
              "no atlas sphere_half_space_strength_ratcheting: tricontact run computes it");
    c.friction.coefficient = .3;
    EXPECT_NE(refusal_of(c).find("laws of friction other than"), std::string::npos);
    c.friction.coefficient.reset();
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.length = .01;
    EXPECT_NE(refusal_of(c).find("line contacts under a shear strength"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::atlas::predictable_test
