// Holes of substrates in case files.

#include <gtest/gtest.h>

#include <string>

#include "contact/base/error.h"
#include "io/case/case_reader.h"

namespace tricontact::io::hole_checks_test {
namespace {

using contact::Case;

const std::string pin =
    "length = \"80 mm\"\nyoung = \"2 MPa\"\npoisson = 0.3\nbody = \"pin\"\nsupport = \"hub\"\n"
    "hub_radius = \"2 mm\"\n";
const std::string plate =
    "shape = \"hole\"\nhole_radius = \"10.1 mm\"\nouter_radius = \"90 mm\"\nyoung = \"2 MPa\"\n"
    "poisson = 0.3\n";

Case parsed(const std::string& indenter, const std::string& substrate,
            const std::vector<std::string>& changes = {}) {
    return parse_case(
        "models = [\"fem-plane\"]\n[indenter]\nshape = \"cylinder\"\nradius = \"10 "
        "mm\"\n" +
            indenter + "[substrate]\n" + substrate +
            "[friction]\ncoefficient = 0.5\n[load]\nindentation = \"0.1 "
            "mm\"\ntangential_ratio = 0\n",
        "case.toml", changes);
}

std::string message_of(const std::string& indenter, const std::string& substrate,
                       const std::vector<std::string>& changes = {}) {
    try {
        parsed(indenter, substrate, changes);
    } catch (const contact::InputError& error) {
        const std::string text = error.what();  // after the place in the file
        return text.substr(text.find(": ") + 2);
    }
    return "no error";
}

TEST(HoleChecks, ComesBackFromAResolvedCase) {
    const Case c = parsed(pin, plate);
    EXPECT_TRUE(c.has_hole());
    EXPECT_FALSE(c.contact.coupling);
    const Case again = parse_case(write_case(c), "again.toml");
    EXPECT_EQ(again.hole.radius, 10.1e-3);
    EXPECT_EQ(again.hole.outer_radius, 90e-3);
    EXPECT_EQ(write_case(again), write_case(c));
}

TEST(HoleChecks, APlateMayBeRigidAndSoMayThePin) {
    EXPECT_TRUE(parsed(pin, "shape = \"hole\"\nhole_radius = \"10.1 mm\"\nrigid = true\n")
                    .has_rigid_substrate);
    EXPECT_FALSE(parsed("length = \"80 mm\"\n", plate).indenter.material);
}

TEST(HoleChecks, RadiiFit) {
    EXPECT_EQ(message_of(pin, plate, {"substrate.hole_radius=9.9 mm"}),
              "substrate.hole_radius = \"9.9 mm\": is not above the radius of 0.01 m of what is "
              "pressed in the hole; enlarge it");
    EXPECT_EQ(message_of(pin, plate, {"substrate.hole_radius=12 mm"}),
              "substrate.hole_radius = \"12 mm\": leaves a clearance above 0.1 of the radius of "
              "0.01 m: it is taken as small beside it; reduce it");
    EXPECT_EQ(message_of(pin, plate, {"substrate.outer_radius=10 mm"}),
              "substrate.outer_radius = \"10 mm\": is not above the radius of 0.0101 m of the "
              "hole; enlarge it");
    EXPECT_EQ(message_of(pin, plate, {"indenter.hub_radius=10 mm"}),
              "indenter.hub_radius = \"10 mm\": is not smaller than the radius of 0.01 m; reduce "
              "it");
}

TEST(HoleChecks, NeedsWhatKnowsIt) {
    EXPECT_EQ(message_of(pin, plate, {"models=[\"bem\"]"}),
              "models = [\"bem\"]: bem has a flat substrate, without a hole; take fem-plane");
    EXPECT_EQ(message_of(pin, plate, {"load.tangential_ratio=0.2"}),
              "load.tangential_ratio = 0.2: in a hole bodies are pressed alone; "
              "set load.tangential_ratio = 0");
    EXPECT_EQ(message_of(pin, plate, {"contact.coupling=true"}), "no error");  // with friction
    EXPECT_EQ(message_of(pin, plate, {"substrate.thickness=8 mm"}),
              "substrate.thickness = \"8 mm\": a plate about a hole is no layer; omit it, or omit "
              "substrate.shape");
    EXPECT_EQ(message_of(pin, plate, {"substrate.shape=layer"}),
              "substrate.hole_radius = \"10.1 mm\": the substrate has no hole; omit it, or take "
              "substrate.shape = \"hole\"");
}

}  // namespace
}  // namespace tricontact::io::hole_checks_test
