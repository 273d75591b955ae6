// Rules of the finite element layer: sharp where they are meant to be, and no case refused that
// could be computed.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "contact/base/error.h"
#include "io/case/case_checks.h"
#include "io/case/case_reader.h"
#include "theory/layer/line_contact.h"

namespace tricontact::io::fem_checks_test {
namespace {

using contact::Case;

const std::string text = R"(models = ["fem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
)";

Case parsed(const std::vector<std::string>& overrides = {}, const std::string& more = {}) {
    return parse_case(text + more, "layer.toml", overrides);
}

std::string set(const char* key, double value, const char* unit) {
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, "%s=%.17g %s", key, value, unit);
    return buffer;
}

std::string message_of(const std::vector<std::string>& overrides) {
    try {
        parsed(overrides);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

struct ExactLayer {
    double
        thickness_ratio;  // b over the radius that the bounds start from: Hertz' at the same load
    double radius_ratio;  // a over that radius
};

// Bonded, nu = 1/2, at equal force: Fredholm's equation of the layer, four digits.
TEST(RadiusBounds, EncloseTheExactRadiusAtAGivenForce) {
    const double hertz = contact::half_space_scales(parsed()).contact_radius;
    for (const ExactLayer exact : {ExactLayer{0.0022, 0.0881},
                                   {0.0290, 0.2897},
                                   {0.2040, 0.6121},
                                   {0.5, 0.790},
                                   {0.8917, 0.8917},
                                   {2, 0.976},
                                   {8, 0.9995}}) {
        const Case c = parsed({set("substrate.thickness", exact.thickness_ratio * hertz, "m")});
        const RadiusBounds bounds = contact_radius_bounds(c);
        EXPECT_LE(bounds.low, exact.radius_ratio * hertz) << exact.thickness_ratio;
        EXPECT_GE(bounds.low, 0.7 * exact.radius_ratio * hertz) << exact.thickness_ratio;
        EXPECT_GE(bounds.high, exact.radius_ratio * hertz) << exact.thickness_ratio;
        EXPECT_LE(bounds.high, hertz * (1 + 1e-15));  // a cubic root's rounding
    }
}

// At equal indentation; chi = sqrt(R d)/b from 0.1 to 20.668.
TEST(RadiusBounds, EncloseTheExactRadiusAtAGivenIndentation) {
    for (const ExactLayer exact : {ExactLayer{1 / 0.1, 1.0410},
                                   {1 / 0.5, 1.2383},
                                   {1, 1.4095},
                                   {0.5, 1.577},
                                   {1 / 5.588, 1.7895},
                                   {1 / 20.668, 1.9354}}) {
        const double hertz = 4e-3;  // d = 0.4 mm
        const Case c = parsed({"load.indentation=0.4 mm",
                               set("substrate.thickness", exact.thickness_ratio * hertz, "m"),
                               "models=[\"mdr\"]"});
        const RadiusBounds bounds = contact_radius_bounds(c);
        EXPECT_LE(bounds.low, exact.radius_ratio * hertz) << exact.thickness_ratio;
        EXPECT_GE(bounds.high, exact.radius_ratio * hertz) << exact.thickness_ratio;
        EXPECT_LE(bounds.high, 2 * exact.radius_ratio * hertz) << exact.thickness_ratio;
    }
}

TEST(RadiusBounds, GrowWithTheLoadsCrestAndOnASofterLowerLayer) {
    const std::string rolling = "[rolling]\namplitude = \"1 mm\"\n";
    const RadiusBounds mean = contact_radius_bounds(parsed({}, rolling));
    const RadiusBounds crest = contact_radius_bounds(
        parsed({"load.normal_amplitude_ratio=0.331", "load.tangential_ratio=0.1"}, rolling));
    EXPECT_NEAR(crest.high, 1.1 * mean.high, 1e-12 * mean.high);  // 1.331 = 1.1^3
    EXPECT_GT(crest.low, mean.low);
    const std::string lower = "[lower_layer]\nthickness = \"2 mm\"\npoisson = 0.5\nyoung = ";
    EXPECT_NEAR(contact_radius_bounds(parsed({}, lower + "\"0.65 MPa\"\n")).high, 2 * mean.high,
                1e-12 * mean.high);  // 8 times softer
    EXPECT_EQ(contact_radius_bounds(parsed({}, lower + "\"70 GPa\"\n")).high, mean.high);
}

// Compressible or not, bonded or gliding, by theory/layer/line_contact.
TEST(RadiusBounds, EncloseTheExactHalfWidthOfALine) {
    const std::vector<std::string> line{"indenter.shape=cylinder", "indenter.length=80 mm",
                                        "load.normal_force=32.3 N"};
    const double hertz = contact::half_space_scales(parsed(line)).contact_radius;
    for (const double ratio : {.05, .3, 1., 3., 30., 300.})
        for (const double nu : {0., .3, .5})
            for (const auto base : {theory::LayerBase::bonded, theory::LayerBase::frictionless}) {
                auto overrides = line;
                overrides.push_back(set("substrate.thickness", ratio * hertz, "m"));
                Case c = parsed(overrides);
                c.substrate.poisson = nu;
                const theory::LineContact exact = theory::solve_line_contact(
                    {c.substrate, *c.layer.thickness, base}, c.indenter.radius,
                    {theory::LineControl::Kind::load, *c.load.normal_force / c.indenter.length});
                const RadiusBounds at_force = contact_radius_bounds(c);
                EXPECT_LE(at_force.low, exact.half_width) << ratio << ' ' << nu;
                EXPECT_GE(at_force.high, exact.half_width) << ratio << ' ' << nu;
                Case pressed = c;
                pressed.load.normal_force.reset();
                pressed.load.indentation = exact.indentation;
                const RadiusBounds at_depth = contact_radius_bounds(pressed);
                EXPECT_LE(at_depth.low, exact.half_width) << ratio << ' ' << nu;
                EXPECT_GE(at_depth.high, exact.half_width) << ratio << ' ' << nu;
            }
}

TEST(FemChecks, TheRigIsAccepted) {
    EXPECT_EQ(message_of({}), "(accepted)");
    EXPECT_EQ(message_of({"fem.size=0.5 mm", "indenter.young=206 GPa", "indenter.poisson=0.3"}),
              "(accepted)");
    EXPECT_EQ(message_of({"fem.size=0.25 mm", "rolling.amplitude_ratio=0.51",
                          "rolling.angle=90 deg", "substrate.base=frictionless"}),
              "(accepted)");
}

TEST(FemChecks, CompressibleSubstratesCoupleAndAreAccepted) {
    EXPECT_EQ(message_of({"substrate.poisson=0.3"}), "(accepted)");
    EXPECT_EQ(message_of({"substrate.poisson=0.3", "models=[\"fem\", \"bem\"]"}), "(accepted)");
    EXPECT_NE(message_of({"substrate.poisson=0.3", "models=[\"fem\", \"mdr\"]"})
                  .find("leave out mdr (bem and bem-layer do), or set contact.coupling = false"),
              std::string::npos);
    EXPECT_EQ(message_of(
                  {"substrate.poisson=0.3", "models=[\"fem\", \"mdr\"]", "contact.coupling=false"}),
              "(accepted)");
}

// The compliances are those of plane strain: (1 - 0.3^2)/E over 0.75/5.2 MPa.
TEST(FemChecks, TheLimitOfARigidIndenterIsSharp) {
    const double limit = 1e3 * 0.91 * 5.2e6 / 0.75;
    const auto with = [&](double young) {
        return message_of({set("indenter.young", young, "Pa"), "indenter.poisson=0.3"});
    };
    EXPECT_EQ(with(limit * 1.001), "(accepted)");
    EXPECT_NE(with(limit * 0.999).find("fem takes the indenter as rigid"), std::string::npos);
}

TEST(FemChecks, TheCoarsestSizeHasTwoElementsInTheLargestPossibleRadius) {
    const double hertz = contact::half_space_scales(parsed()).contact_radius;
    EXPECT_EQ(message_of({set("fem.size", hertz / 2 * 0.999, "m")}), "(accepted)");
    EXPECT_NE(message_of({set("fem.size", hertz / 2 * 1.001, "m")}).find("too coarse"),
              std::string::npos);
    // At a given indentation the contact on a thin layer is up to twice as large as Hertz'.
    EXPECT_EQ(message_of({"load.indentation=0.4 mm", set("fem.size", 4e-3 * 0.999, "m")}),
              "(accepted)");
    EXPECT_NE(message_of({"load.indentation=0.4 mm", set("fem.size", 4e-3 * 1.001, "m")})
                  .find("too coarse"),
              std::string::npos);
}

// Static: half a square patch of side 2 a. 3 (4 n + 1)(2 n + 1) unknowns for n elements in a:
// 58509 for n = 49, 60903 for n = 50.
TEST(FemChecks, TheFinestSizeFillsTheMemory) {
    const double low = contact_radius_bounds(parsed()).low;
    EXPECT_EQ(message_of({set("fem.size", low / 48.9, "m")}), "(accepted)");
    const std::string too_fine = set("fem.size", low / 49.1, "m"), direct = "fem.solver=direct";
    EXPECT_NE(message_of({too_fine, direct}).find("need 6.09e+04 unknowns"), std::string::npos);
    EXPECT_EQ(message_of({too_fine}), "(accepted)");  // by iteration
    EXPECT_NE(message_of({"fem.size=1e-300 m", direct}).find("need inf unknowns"),
              std::string::npos);
    EXPECT_NE(message_of({"fem.size=1e-300 m"}).find("would take days"), std::string::npos);
    EXPECT_NE(message_of({"fem.size=1e-300 m", "fem.solver=iterative"}).find("inf elements"),
              std::string::npos);
}

TEST(FemChecks, PerpendicularRollingHasNoPlaneOfSymmetry) {
    const std::vector<std::string> along{"fem.size=0.1 mm", "rolling.amplitude=1 mm",
                                         "rolling.periods=1"};
    std::vector<std::string> across = along;
    across.emplace_back("rolling.angle=90 deg");
    across.emplace_back("fem.solver=direct");
    EXPECT_EQ(message_of(along), "(accepted)");
    EXPECT_NE(message_of(across).find(" unknowns, more than 6e+04"), std::string::npos);
}

TEST(FemChecks, TheBlockMustHoldContactAndPath) {
    const double low = contact_radius_bounds(parsed()).low;
    EXPECT_EQ(message_of({set("substrate.width", 2.001 * low, "m")}), "(accepted)");
    EXPECT_NE(message_of({set("substrate.width", 1.999 * low, "m")}).find("do not fit"),
              std::string::npos);
    const auto rolled = [&](double depth, const char* angle) {
        return message_of({set("substrate.depth", depth, "m"), "rolling.amplitude=3 mm",
                           std::string("rolling.angle=") + angle});
    };
    EXPECT_EQ(rolled(2.001 * low, "0 deg"), "(accepted)");
    EXPECT_NE(rolled(2.001 * low, "90 deg").find("do not fit"), std::string::npos);
    EXPECT_EQ(rolled(2.001 * (low + 3e-3), "-90 deg"), "(accepted)");
}

// On a layer a force presses less deep: the sphere's limits must not be those of the half-space.
TEST(FemChecks, ASphereOnALayerIsNotJudgedByTheHalfSpace) {
    const std::vector<std::string> steep{"indenter.shape=sphere", "indenter.radius=8.5 mm",
                                         "load.normal_force=90 N"};
    std::vector<std::string> half_space = steep;
    half_space.emplace_back("models=[\"mdr\"]");
    EXPECT_EQ(message_of(steep), "(accepted)");
    EXPECT_NE(message_of(half_space).find("exceeds 0.5 of the sphere's radius"), std::string::npos);
    std::vector<std::string> crushed = steep;
    crushed.back() = "load.normal_force=3000 N";
    EXPECT_NE(message_of(crushed).find("exceeds 0.5 of the sphere's radius"), std::string::npos);
}

TEST(FemChecks, OtherModelsIgnoreTheRules) {
    EXPECT_EQ(message_of({"models=[\"mdr\", \"bem\"]", "fem.size=1 m", "substrate.width=1 um",
                          "fem.growth=1.05"}),
              "(accepted)");
    EXPECT_EQ(message_of({"models=[\"mdr\"]", "fem.mesh=no/such.msh"}), "(accepted)");
}

}  // namespace
}  // namespace tricontact::io::fem_checks_test
