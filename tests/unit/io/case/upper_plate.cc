// The plate above a body between two that are not alike, in case files.

#include "contact/bodies/upper_plate.h"

#include <gtest/gtest.h>

#include <string>

#include "comparisons/quantities/left_out.h"
#include "contact/base/error.h"
#include "io/case/case_reader.h"

namespace tricontact::io::upper_plate_test {
namespace {

using contact::Case;
using contact::UpperPlate;

const std::string ball = R"(models = ["fem-axisymmetric"]
[indenter]
shape = "sphere"
radius = "10 mm"
young = "2 MPa"
poisson = 0.3
body = "ball"
support = "plates"
[substrate]
rigid = true
[upper_plate]
young = "4 MPa"
poisson = 0.45
thickness = "5 mm"
[friction]
coefficient = 0.5
[load]
normal_force = "1 N"
tangential_ratio = 0
)";

std::string message_of(const std::vector<std::string>& changes) {
    try {
        parse_case(ball, "case.toml", changes);
        return "accepted";
    } catch (const contact::InputError& error) {
        std::string message = error.what();
        const auto key = message.find(": ");
        return message.substr(key + 2);
    }
}

TEST(UpperPlate, IsReadAndWritten) {
    const Case c = parse_case(ball, "case.toml");
    const auto* const plate = c.kept.find<UpperPlate>();
    ASSERT_NE(plate, nullptr);
    EXPECT_FALSE(plate->is_rigid);
    EXPECT_EQ(plate->material.young, 4e6);
    EXPECT_EQ(plate->thickness, 5e-3);
    EXPECT_FALSE(c.contact.coupling);  // which it is by default elsewhere
    EXPECT_EQ(write_case(parse_case(write_case(c), "again.toml")), write_case(c));

    std::string text = ball;
    text.replace(text.find("young = \"4 MPa\""), 50, "rigid = true\n");
    const Case rigid = parse_case(text, "case.toml");
    EXPECT_TRUE(rigid.kept.find<UpperPlate>()->is_rigid);
    EXPECT_EQ(write_case(parse_case(write_case(rigid), "again.toml")), write_case(rigid));
    EXPECT_EQ(write_case(rigid).find("thickness"), std::string::npos);
}

TEST(UpperPlate, IsLeftOutByModelsOfOneContact) {
    const Case c = parse_case(ball, "case.toml", {"models=[\"fem-axisymmetric\", \"bem\"]"});
    EXPECT_TRUE(comparisons::left_out(c, "fem-axisymmetric").empty());
    const std::vector<std::string> left = comparisons::left_out(c, "bem");
    EXPECT_EQ(left.back(), "upper_plate: the contact with the substrate alone");
}

TEST(UpperPlate, GoesWithABodyBetweenTwoPlatesThatIsPressedAlone) {
    EXPECT_NE(message_of({"upper_plate.rigid=true"}).find("neither material nor thickness"),
              std::string::npos);
    EXPECT_NE(message_of({"indenter.support=\"hub\"", "indenter.hub_radius=\"3 mm\""})
                  .find("no body of the case lies between two plates"),
              std::string::npos);
    EXPECT_NE(message_of({"contact.coupling=true"}).find("pressed without friction"),
              std::string::npos);
    EXPECT_NE(message_of({"models=[\"fem\"]"}).find("between plates that are alike"),
              std::string::npos);
    EXPECT_NE(message_of({"output.volume=\"last\""}).find("is not shown"), std::string::npos);
    EXPECT_NE(message_of({"interface.normal_stiffness=\"10 MPa/mm\"",
                          "interface.tangential_stiffness=\"10 MPa/mm\""})
                  .find("no springs of an interface"),
              std::string::npos);
    EXPECT_NE(
        message_of({"substrate.rigid=false", "substrate.young=\"2 MPa\"", "substrate.poisson=0.3",
                    "substrate.thickness=\"5 mm\"", "substrate.relaxation.relative_moduli=[0.4]",
                    "substrate.relaxation.times=[\"0.5 s\"]"})
            .find("unlike plates are elastic"),
        std::string::npos);
    EXPECT_NE(message_of({"load.tangential_ratio=0.2"}).find("along the axis alone"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::upper_plate_test
