// Bodies of indenters that deform, and rigid substrates, in case files.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "io/case/case_reader.h"

namespace tricontact::io::elastic_bodies_test {
namespace {

using contact::Case;
using contact::ElasticBody;

const std::string rest =
    "[friction]\ncoefficient = 0.5\n[load]\nindentation = \"0.1 mm\"\ntangential_ratio = 0.3\n";
const std::string elastic = "young = \"2 MPa\"\npoisson = 0.495\n";

Case parsed(const std::string& indenter, const std::string& substrate,
            const std::string& model = "bem") {
    return parse_case("models = [\"" + model + "\"]\n[indenter]\nradius = \"10 mm\"\n" + indenter +
                          "[substrate]\n" + substrate + rest,
                      "case.toml");
}

std::string message_of(const std::string& indenter, const std::string& substrate,
                       const std::string& model = "bem") {
    try {
        parsed(indenter, substrate, model);
    } catch (const contact::InputError& error) {
        const std::string text = error.what();  // after the place in the file
        return text.substr(text.find(": ") + 2);
    }
    return "no error";
}

const std::string hemisphere =
    "shape = \"sphere\"\n" + elastic + "body = \"hemisphere\"\nsupport = \"holder\"\n";
const std::string cylinder = "shape = \"cylinder\"\nlength = \"80 mm\"\n" + elastic;

TEST(ElasticBodies, ComeBackFromAResolvedCase) {
    const Case c =
        parsed(cylinder + "body = \"cylinder\"\nsupport = \"hub\"\nhub_radius = \"3 mm\"\n",
               "rigid = true\n");
    const Case again = parse_case(write_case(c), "again.toml");
    ASSERT_TRUE(again.indenter.body);
    EXPECT_EQ(again.indenter.body->form, ElasticBody::Form::cylinder);
    EXPECT_EQ(again.indenter.body->support, ElasticBody::Support::hub);
    EXPECT_EQ(again.indenter.body->hub_radius, 3e-3);
    EXPECT_TRUE(again.has_rigid_substrate);
    EXPECT_TRUE(std::isinf(again.substrate.young));
    EXPECT_EQ(write_case(again), write_case(c));
}

TEST(ElasticBodies, RigidSubstratesMayBeDenied) {
    const Case c = parsed(hemisphere, elastic + "rigid = false\n");
    EXPECT_FALSE(c.has_rigid_substrate);
    EXPECT_EQ(c.substrate.young, 2e6);
    EXPECT_EQ(write_case(c).find("rigid"), std::string::npos);
}

// Hertz: the same whichever of both bodies is the rigid one.
TEST(ElasticBodies, OnARigidSubstratePressAsARigidOneOnThem) {
    const Case above = parsed("shape = \"sphere\"\n" + elastic, "rigid = true\n");
    const Case below = parsed("shape = \"sphere\"\n", elastic);
    EXPECT_EQ(half_space_scales(above).normal_force, half_space_scales(below).normal_force);
}

TEST(ElasticBodies, AreRefusedWhereTheyDoNotFit) {
    EXPECT_EQ(message_of("body = \"hemisphere\"\nsupport = \"holder\"\n", elastic),
              "indenter.body = \"hemisphere\": has no effect without indenter.young, "
              "which is missing; give indenter.young too, or omit this key");
    EXPECT_EQ(message_of("shape = \"sphere\"\n" + elastic + "body = \"hemisphere\"\n", elastic),
              "missing key indenter.support; add support = \"holder\"");
    EXPECT_EQ(
        message_of("shape = \"sphere\"\n" + elastic + "body = \"cylinder\"\nsupport = \"plates\"\n",
                   elastic),
        "indenter.body = \"cylinder\": the body \"cylinder\" has no surface of "
        "the shape \"sphere\"; take indenter.shape = \"cylinder\", or another body");
    EXPECT_EQ(
        message_of("shape = \"sphere\"\n" + elastic + "body = \"ball\"\nsupport = \"holder\"\n",
                   elastic),
        "indenter.support = \"holder\": the body \"ball\" is not held by "
        "\"holder\"; take \"plates\" or \"hub\"");
    EXPECT_EQ(message_of(hemisphere + "hub_radius = \"1 mm\"\n", elastic),
              "indenter.hub_radius = \"1 mm\": the body is not held by a hub; omit "
              "it, or take indenter.support = \"hub\"");
    EXPECT_EQ(message_of(cylinder + "body = \"cylinder\"\nsupport = \"hub\"\n"
                                    "hub_radius = \"10 mm\"\n",
                         elastic),
              "indenter.hub_radius = \"10 mm\": is not smaller than the radius of "
              "0.01 m; reduce it");
    EXPECT_EQ(message_of(hemisphere + "height = \"1 mm\"\n", elastic),
              "indenter.height = \"1 mm\": the body \"hemisphere\" has the height "
              "that its radius says; omit it");
}

TEST(ElasticBodies, RigidSubstratesHaveNeitherMaterialNorThickness) {
    EXPECT_EQ(message_of("", "rigid = true\n"),
              "substrate.rigid = true: has no effect without indenter.young, "
              "which is missing; give indenter.young too, or omit this key");
    EXPECT_EQ(message_of(elastic, "rigid = true\nyoung = \"2 MPa\"\n"),
              "substrate.young = \"2 MPa\": a rigid substrate has neither material "
              "nor thickness; omit it, or omit substrate.rigid");
    EXPECT_EQ(message_of(elastic, "rigid = true\nthickness = \"2 mm\"\n"),
              "substrate.thickness = \"2 mm\": a rigid substrate has neither material "
              "nor thickness; omit it, or omit substrate.rigid");
    EXPECT_EQ(message_of(elastic, "rigid = true\n", "bem-layer"),
              "models = [\"bem-layer\"]: bem-layer models a substrate that deforms; "
              "leave it out, or omit substrate.rigid");
}

}  // namespace
}  // namespace tricontact::io::elastic_bodies_test
