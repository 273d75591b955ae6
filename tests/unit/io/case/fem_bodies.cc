// What fem computes of an indenter's body, and what it refuses.

#include <gtest/gtest.h>

#include <string>

#include "comparisons/quantities/left_out.h"
#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "tests/paths.h"

namespace tricontact::io::fem_bodies_test {
namespace {

using contact::Case;

const std::string silicone = "young = \"2 MPa\"\npoisson = 0.495\n";
const std::string hemisphere =
    "shape = \"sphere\"\n" + silicone + "body = \"hemisphere\"\nsupport = \"holder\"\n";
const std::string ball =
    "shape = \"sphere\"\n" + silicone + "body = \"ball\"\nsupport = \"plates\"\n";
const std::string layer = "young = \"4 MPa\"\npoisson = 0.495\nthickness = \"5 mm\"\n";
const std::string loaded = "[load]\nindentation = \"0.1 mm\"\ntangential_ratio = 0.3\n";
const std::string pressed = "[load]\nindentation = \"0.1 mm\"\ntangential_force = \"0 N\"\n";

Case parsed(const std::string& indenter, const std::string& substrate, const std::string& rest,
            const std::string& models = "\"fem\"") {
    return parse_case("models = [" + models + "]\n[indenter]\nradius = \"10 mm\"\n" + indenter +
                          "[substrate]\n" + substrate + "[friction]\ncoefficient = 0.5\n" + rest,
                      "case.toml");
}

// From the place on, without the line.
std::string refusal(const std::string& indenter, const std::string& substrate,
                    const std::string& rest) {
    try {
        parsed(indenter, substrate, rest);
    } catch (const contact::InputError& error) {
        const std::string what = error.what();
        return what.substr(what.find(": ") + 2);
    }
    return "accepted";
}

TEST(FemBodies, AreAcceptedOnLayersAndRigidPlanes) {
    for (const std::string& substrate : {std::string("rigid = true\n"), layer}) {
        EXPECT_EQ(refusal(hemisphere, substrate, loaded), "accepted");
        EXPECT_EQ(refusal(hemisphere, substrate, pressed), "accepted");
        EXPECT_EQ(refusal(ball, substrate, pressed), "accepted");
    }
}

TEST(FemBodies, AreAcceptedOnLayersThatRelax) {
    EXPECT_EQ(
        refusal(hemisphere,
                layer + "[substrate.relaxation]\nrelative_moduli = [0.5]\ntimes = [\"1 s\"]\n",
                loaded),
        "accepted");
}

TEST(FemBodies, HalfSpaceModelsSayThatTheyLeaveThemOut) {
    const Case c = parsed(hemisphere, "rigid = true\n", loaded, "\"bem\", \"fem\"");
    EXPECT_EQ(comparisons::left_out(c, "bem"),
              std::vector<std::string>{"indenter.body: the indenter is a half-space"});
    EXPECT_TRUE(comparisons::left_out(c, "fem").empty());
}

TEST(FemBodies, OfAHalfSpaceNothingIsMeshed) {
    EXPECT_EQ(
        refusal("shape = \"sphere\"\n" + silicone, "rigid = true\n", loaded),
        "substrate.rigid = true: fem meshes no half-space: neither body is one that it can "
        "deform; give indenter.body or indenter.mesh, the finite body that it is, or leave out "
        "fem");
    EXPECT_EQ(
        refusal("shape = \"sphere\"\n" + silicone, layer, loaded),
        "indenter.young = \"2 MPa\": fem takes the indenter as rigid, but its compliance (1 - "
        "poisson^2)/young is 2 of the substrate's, more than 0.001; give indenter.body or "
        "indenter.mesh, the finite body that it is, omit young and poisson of the indenter to make "
        "it rigid, or "
        "leave out fem");
}

// Turned by a few degrees a hemisphere touches with another part of itself, and its flat face is no
// longer parallel to the substrate.
TEST(FemBodies, RollAboutAHubAlone) {
    const std::string rolling = "[rolling]\namplitude_ratio = 0.2\nperiods = 2\n";
    EXPECT_EQ(
        refusal(hemisphere, "rigid = true\n", loaded + rolling),
        "rolling.amplitude_ratio = 0.2: fem rolls a cylinder or ball on a hub; a hemisphere "
        "held by a rigid holder has another stiffness after it has turned: it is not of revolution "
        "about the axis that it rolls about; leave out fem, or indenter.body");
    EXPECT_EQ(refusal(ball, "rigid = true\n", pressed + rolling),
              "rolling.amplitude_ratio = 0.2: fem rolls a cylinder or ball on a hub; a ball held "
              "by a second plate stands by symmetry alone, which rolling breaks; leave out fem, or "
              "indenter.body");
    const std::string cylinder = "shape = \"cylinder\"\nlength = \"60 mm\"\n" + silicone +
                                 "body = \"cylinder\"\nsupport = \"hub\"\n"
                                 "hub_radius = \"3 mm\"\n";
    for (const std::string& substrate : {std::string("rigid = true\n"), layer})
        EXPECT_EQ(refusal(cylinder, substrate, loaded + rolling), "accepted");
    EXPECT_EQ(refusal(cylinder, layer, loaded + rolling + "[output]\nvolume = \"last\"\n"),
              "accepted");
    EXPECT_EQ(refusal(cylinder, layer, loaded + rolling + "[output]\nvolume = \"quarters\"\n"),
              "output.volume = \"quarters\": fem shows the inside of a body that rolls where "
              "it stands upright, after a period of [rolling]; take volume = \"last\"");
    EXPECT_EQ(refusal(cylinder, layer, loaded + "[rolling]\namplitude = \"21 mm\"\nperiods = 2\n"),
              "rolling.amplitude = \"21 mm\": fem turns a cylinder about its hub by no more than "
              "115 degrees to either side; reduce it to two radii, or leave indenter.body out");
}

TEST(FemBodies, BetweenPlatesTakeNoTangentialLoad) {
    EXPECT_EQ(refusal(ball, "rigid = true\n", loaded),
              "load.tangential_ratio = 0.3: a body between two plates rolls or spins under a "
              "tangential load: nothing "
              "holds it; set the tangential load to 0, or take another support");
}

TEST(FemBodies, AreNeitherFinitelyStrainedNorMeshedByAFile) {
    EXPECT_EQ(refusal(hemisphere, layer + "material = \"neo-hookean\"\n", loaded),
              "indenter.body = \"hemisphere\": at finite strains fem takes the indenter as rigid; "
              "leave it out, or set substrate.material to \"linear\"");
    EXPECT_EQ(refusal(hemisphere, layer, loaded + "[fem]\nmesh = \"layer.msh\"\n"),
              "fem.mesh = \"layer.msh\": the nodes of a mesh file do not match those of the "
              "indenter's body; omit it, or give the indenter's mesh as indenter.mesh");
    // The inside of the indenter is shown, also on a rigid substrate.
    EXPECT_EQ(refusal(hemisphere, "rigid = true\n", loaded + "[output]\nvolume = \"last\"\n"),
              "accepted");
}

TEST(FemBodies, AFileSaysHowFineItIsAndWhatHoldsIt) {
    const std::string meshed =
        "shape = \"sphere\"\n" + silicone + "mesh = \"" + paths::source("README.md") + "\"\n";
    const auto expect = [](const std::string& message, const std::string& what) {
        EXPECT_NE(message.find(what), std::string::npos) << message;
    };
    EXPECT_NO_THROW(parsed(meshed, layer, loaded));
    expect(refusal(meshed + "body = \"hemisphere\"\nsupport = \"holder\"\n", layer, loaded),
           "indenter.body gives the indenter another body; keep one of them");
    expect(refusal(meshed + "height = \"1 mm\"\n", layer, loaded),
           "has no effect without indenter.body, which is missing");
    expect(refusal(meshed, layer, loaded + "[fem]\naccuracy = 0.01\n"),
           "fem.accuracy = 0.01: the size of elements is that of the indenter's mesh");
    expect(refusal(meshed, layer,
                   loaded + "[fem]\nmesh = \"" + paths::source("README.md") +
                       "\"\nsides = \"fixed\"\n"),
           "fem.sides = \"fixed\": a body of a file is held by its surface \"support\"; omit it");
    expect(refusal(meshed, "rigid = true\n", loaded + "[fem]\nsize = \"1 mm\"\n"),
           "the only mesh is the indenter's, which is a file's; omit it");
}

}  // namespace
}  // namespace tricontact::io::fem_bodies_test
