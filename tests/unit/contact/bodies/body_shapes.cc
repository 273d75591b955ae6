// The table of shapes: its places, and what its rows say beside the bodies that they make.

#include "contact/bodies/body_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "contact/case.h"

namespace tricontact::body_shapes_test {
namespace {

using contact::BodyShape;
using contact::IndenterData;
using enum IndenterData::Shape;

/// Lengths for all shapes, all different from 1.
IndenterData data() {
    IndenterData d;
    d.radius = .04;
    d.radius_y = .06;
    d.length = .08;
    d.chamfer = .001;
    d.angle = .1;
    d.exponent = 3;
    d.flat_radius = .005;
    d.profile = {{0, 0, true}, {.01, 1e-3, false}, {.02, 3e-3, false}};
    d.height_map = std::make_shared<contact::HeightMap>(
        contact::HeightMap{.n_x = 2, .n_y = 2, .spacing = {1e-3, 1e-3}, .height = {0, 1, 2, 3}});
    return d;
}

TEST(BodyShapes, NamesStandAtTheRowsOfTheirWords) {
    const std::pair<IndenterData::Shape, const char*> named[] = {{paraboloid, "paraboloid"},
                                                                 {sphere, "sphere"},
                                                                 {cylinder, "cylinder"},
                                                                 {roller, "roller"},
                                                                 {cone, "cone"},
                                                                 {power_law, "power-law"},
                                                                 {rounded_punch, "rounded-punch"},
                                                                 {ellipsoid, "ellipsoid"},
                                                                 {profile, "profile"},
                                                                 {flat, "flat"},
                                                                 {height_map, "height-map"}};
    for (const auto& [shape, word] : named) EXPECT_EQ(contact::body_shape(shape).word, word);
    std::set<std::string_view> words;
    for (const BodyShape& one : contact::body_shapes())
        EXPECT_TRUE(words.insert(one.word).second) << one.word;
}

TEST(BodyShapes, EachRowMakesItsBodyInOneWay) {
    for (const BodyShape& one : contact::body_shapes()) {
        EXPECT_NE(one.of_revolution == nullptr, one.other == nullptr) << one.word;
        const auto body = one.make(data());
        const contact::Vector2 lowest = body->lowest_point();
        EXPECT_EQ(body->height(lowest[0], lowest[1]), 0) << one.word;
    }
}

// Sneddon (1965): the pressure at the centre is infinite under a tip of finite slope only.
TEST(BodyShapes, AConicalTipHasAnInfinitePressureAtTheCentre) {
    for (const BodyShape& one : contact::body_shapes()) {
        if (!one.of_revolution) continue;
        for (const double exponent : {1., 3.}) {
            IndenterData d = data();
            d.exponent = exponent;
            const bool says = one.has_conical_tip && one.has_conical_tip(d);
            EXPECT_EQ(says, std::isinf(one.of_revolution(d)->centre_pressure(.004))) << one.word;
        }
    }
}

}  // namespace
}  // namespace tricontact::body_shapes_test
