// Punches with a sharp edge or along y, and bodies that nothing holds, in case files.

#include <gtest/gtest.h>

#include <string>

#include "contact/base/error.h"
#include "io/case/case_reader.h"

namespace tricontact::io::punch_checks_test {
namespace {

using contact::Case;

const std::string block = R"(models = ["fem-plane"]
[indenter]
shape = "flat-punch"
flat_radius = "5 mm"
length = "200 mm"
young = "2 MPa"
poisson = 0.3
body = "block"
support = "pressure"
height = "4 mm"
[substrate]
young = "2 MPa"
poisson = 0.3
thickness = "50 mm"
[friction]
coefficient = 0.5
[load]
normal_force = "1 N"
tangential_ratio = 0
)";

Case parsed(const std::vector<std::string>& changes = {}) {
    return parse_case(block, "case.toml", changes);
}

std::string message_of(const std::vector<std::string>& changes) {
    try {
        parsed(changes);
    } catch (const contact::InputError& error) {
        const std::string text = error.what();  // after the place in the file
        return text.substr(text.find(": ") + 2);
    }
    return "no error";
}

std::string of_revolution() {
    std::string text = block;
    text.erase(text.find("length"), std::string("length = \"200 mm\"\n").size());
    return text;
}

TEST(PunchChecks, ComesBackFromAResolvedCase) {
    const Case c = parsed();
    EXPECT_TRUE(c.is_line_contact());
    EXPECT_TRUE(c.indenter.body->is_loose());
    const Case again = parse_case(write_case(c), "again.toml");
    EXPECT_EQ(again.indenter.length, .2);
    EXPECT_EQ(again.indenter.body->height, 4e-3);
    EXPECT_EQ(write_case(again), write_case(c));
}

TEST(PunchChecks, WithoutALengthItIsOfRevolution) {
    const Case c = parse_case(of_revolution(), "case.toml", {"models=[\"fem-axisymmetric\"]"});
    EXPECT_FALSE(c.is_line_contact());
    const Case again = parse_case(write_case(c), "again.toml");
    EXPECT_EQ(again.indenter.length, 0);
}

TEST(PunchChecks, ModelsKnowThePunch) {
    EXPECT_EQ(message_of({"models=[\"bem\"]"}),
              "models = [\"bem\"]: bem knows no punch along y; take fem-plane, or omit "
              "indenter.length: it is of revolution then");
    EXPECT_EQ(message_of({"models=[\"fem-axisymmetric\"]"}),
              "models = [\"fem-axisymmetric\"]: fem-axisymmetric knows no punch along y; take "
              "fem-plane, or omit indenter.length: it is of revolution then");
    EXPECT_EQ(message_of({"indenter.length=40 mm"}),
              "indenter.length = \"40 mm\": is less than 5 widths of the punch's flat face: no "
              "line contact; enlarge it");
    EXPECT_THROW(parse_case(of_revolution(), "case.toml"), contact::InputError);
}

TEST(PunchChecks, FemKnowsABlockAlongY) {
    EXPECT_NO_THROW(parse_case(block, "case.toml", {"models=[\"fem\"]"}));
    EXPECT_EQ(message_of({"models=[\"fem\"]", "indenter.support=force"}),
              "indenter.support = \"force\": fem presses a block by a holder or by a pressure; "
              "take one of these, or fem-plane for a concentrated force");
    EXPECT_EQ(message_of({"models=[\"fem\"]", "fem.size=4 mm"}),
              "fem.size = \"4 mm\": fewer than 2 elements in the contact radius of at most 0.005 "
              "m: too coarse; use a size of at most 0.000625 m, or fem.accuracy");
}

TEST(PunchChecks, IsPressedAlone) {
    EXPECT_EQ(message_of({"load.tangential_ratio=0.2"}),
              "load.tangential_ratio = 0.2: nothing holds a body that pressure presses against a "
              "load along the surface; set load.tangential_ratio = 0, or take indenter.support = "
              "\"holder\"");
    EXPECT_EQ(message_of({"indenter.support=force", "load.indentation=0.1 mm"}),
              "load.indentation = \"0.1 mm\": where a force is concentrated the body gives way "
              "without bound: there is no depth; give load.normal_force, or take "
              "indenter.support = \"pressure\"");
    EXPECT_EQ(message_of({"rolling.amplitude=1 mm"}),
              "rolling.amplitude = \"1 mm\": a flat punch does not roll; leave [rolling] out");
    EXPECT_EQ(message_of({"indenter.support=plates"}),
              "indenter.support = \"plates\": the body \"block\" is not held by \"plates\"; take "
              "\"holder\" or \"force\" or \"pressure\"");
}

}  // namespace
}  // namespace tricontact::io::punch_checks_test
