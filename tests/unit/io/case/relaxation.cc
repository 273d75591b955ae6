// A relaxing substrate in case files: four ways of saying it, one case.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "contact/base/error.h"
#include "io/case/case_input.h"
#include "io/case/case_reader.h"

namespace tricontact::io::relaxation_test {
namespace {

using contact::Case;
using contact::Relaxation;

const std::string head = R"(models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.1 MPa"
poisson = 0.5
)";
const std::string tail = R"([friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
hold = "60 s"
press_time = "0.5 s"
[rolling]
amplitude_ratio = 0.24
speed = "1 mm/s"
)";
const std::string standard = "[substrate.relaxation]\nG2 = \"1 MPa\"\neta = \"40 Pa s\"\n";

Case parsed(const std::string& relaxation, const std::vector<std::string>& overrides = {}) {
    return parse_case(head + relaxation + tail, "relaxing.toml", overrides);
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        parse_case(text, "relaxing.toml", overrides);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

void expect_same(const Case& a, const Case& b) {
    ASSERT_TRUE(a.relaxation && b.relaxation);
    ASSERT_EQ(a.relaxation->branches.size(), b.relaxation->branches.size());
    for (std::size_t i = 0; i < a.relaxation->branches.size(); ++i) {
        EXPECT_EQ(a.relaxation->branches[i].ratio, b.relaxation->branches[i].ratio);
        EXPECT_EQ(a.relaxation->branches[i].time, b.relaxation->branches[i].time);
    }
    EXPECT_EQ(a.relaxation->bulk, b.relaxation->bulk);
}

// G_0 = G_inf/(1 - sum g_i), and E_inf of an E_0: closed forms of a Prony series.
TEST(RelaxationInput, RelativeModuliAreThoseOfTheUnrelaxedOne) {
    const std::string terms =
        "[substrate.relaxation]\nrelative_moduli = [0.3, 0.2]\n"
        "times = [\"0.1 s\", \"10 s\"]\n";
    const Case relaxed = parsed(terms);
    EXPECT_DOUBLE_EQ(relaxed.substrate.young, 5.1e6);
    EXPECT_NEAR(relaxed.relaxation->branches[0].ratio, .3 / .5, 1e-12);
    EXPECT_NEAR(relaxed.relaxation->branches[1].ratio, .2 / .5, 1e-12);
    EXPECT_NEAR(relaxed.relaxation->instantaneous_ratio(), 2, 1e-12);
    const Case at_once = parsed(terms + "modulus = \"unrelaxed\"\n");
    EXPECT_NEAR(at_once.substrate.young, 5.1e6 / 2, 1e-6);
    EXPECT_NEAR(at_once.relaxation->branches[0].ratio, .6, 1e-12);
    // The same said by moduli: G_0 = 1.7 MPa.
    const Case said = parsed(
        "[substrate.relaxation]\nmoduli = [\"0.51 MPa\", \"0.34 MPa\"]\n"
        "times = [\"0.1 s\", \"10 s\"]\nmodulus = \"unrelaxed\"\n");
    EXPECT_NEAR(said.substrate.young / at_once.substrate.young, 1, 1e-12);
    EXPECT_NEAR(said.relaxation->branches[1].ratio, .4, 1e-12);
    // The resolved case is one of the relaxed modulus, and reads back the same.
    const std::string text = write_case(at_once);
    EXPECT_NE(text.find("modulus = \"relaxed\""), std::string::npos) << text;
    EXPECT_EQ(write_case(parse_case(text, "resolved.toml")), text);
    expect_same(at_once, parse_case(text, "resolved.toml"));
}

// Of an elastic bulk the bulk modulus is the one that was given: K = E/(3 (1 - 2 nu)).
TEST(RelaxationInput, AnElasticBulkKeepsItsModulusWhenTheUnrelaxedOneIsGiven) {
    const std::string text = head +
                             "[substrate.relaxation]\nrelative_moduli = [0.5]\n"
                             "times = [\"1 s\"]\nmodulus = \"unrelaxed\"\n"
                             "bulk = \"elastic\"\n" +
                             tail;
    const Case c = parse_case(text, "relaxing.toml", {"substrate.poisson=0.4"});
    const double bulk = 5.1e6 / (3 * (1 - .8)), shear = 5.1e6 / 2.8 / 2;
    EXPECT_NEAR(c.substrate.shear_modulus(), shear, 1e-6 * shear);
    EXPECT_NEAR(c.substrate.young / (3 * (1 - 2 * c.substrate.poisson)), bulk, 1e-6 * bulk);
}

TEST(RelaxationInput, RefusesASeriesThatLeavesNothingAtRest) {
    EXPECT_NE(message_of(head +
                         "[substrate.relaxation]\nrelative_moduli = [0.6, 0.4]\n"
                         "times = [\"0.1 s\", \"10 s\"]\n" +
                         tail)
                  .find("the sum is 1: nothing would be left at rest"),
              std::string::npos);
    EXPECT_NE(message_of(head +
                         "[substrate.relaxation]\nmoduli = [\"2 MPa\"]\ntimes = [\"1 s\"]\n"
                         "modulus = \"unrelaxed\"\n" +
                         tail)
                  .find("no less than the unrelaxed shear modulus"),
              std::string::npos);
    EXPECT_NE(message_of(head +
                         "[substrate.relaxation]\nrelative_moduli = [0.3]\n"
                         "moduli = [\"2 MPa\"]\ntimes = [\"1 s\"]\n" +
                         tail)
                  .find("contradicts"),
              std::string::npos);
}

TEST(RelaxationInput, StandardSolid) {
    const Case c = parsed(standard);
    ASSERT_TRUE(c.relaxation);
    ASSERT_EQ(c.relaxation->branches.size(), 1U);
    EXPECT_EQ(c.relaxation->bulk, Relaxation::Bulk::proportional);
    EXPECT_DOUBLE_EQ(c.relaxation->branches[0].ratio, 1 / 1.7);  // G1 = 5.1 MPa/3
    EXPECT_DOUBLE_EQ(c.relaxation->branches[0].time, 40e-6);
    EXPECT_EQ(c.load.hold, 60);
    EXPECT_EQ(c.load.press_time, 0.5);
    EXPECT_EQ(c.rolling->speed, 1e-3);
    EXPECT_FALSE(relaxation_fits(c).dma);
}

TEST(RelaxationInput, PronySeries) {
    const Case c = parsed(R"([substrate.relaxation]
times = ["0.1 s", "2 min"]
moduli = ["850 kPa", "0.34 MPa"]
bulk = "elastic"
)");
    ASSERT_EQ(c.relaxation->branches.size(), 2U);
    EXPECT_DOUBLE_EQ(c.relaxation->branches[0].ratio, 0.5);
    EXPECT_DOUBLE_EQ(c.relaxation->branches[1].ratio, 0.2);
    EXPECT_EQ(c.relaxation->branches[0].time, 0.1);
    EXPECT_EQ(c.relaxation->branches[1].time, 120);
    EXPECT_EQ(c.relaxation->bulk, Relaxation::Bulk::elastic);
}

TEST(RelaxationInput, IsElasticWithoutTheSection) {
    const std::string elastic = head + "[friction]\ncoefficient = 0.57\n" +
                                "[load]\nnormal_force = \"21.1 N\"\ntangential_ratio = 0.5\n";
    const Case c = parse_case(elastic, "elastic.toml");
    EXPECT_FALSE(c.relaxation);
    EXPECT_EQ(c.load.hold, 0);
    const std::string written = write_case(c);
    for (const char* word : {"relaxation", "hold", "press_time", "speed"})
        EXPECT_EQ(written.find(word), std::string::npos) << word;
}

TEST(RelaxationInput, DefaultsAreThoseOfTheStructure) {
    const std::string text = head + standard + "[friction]\ncoefficient = 0.57\n" +
                             "[load]\nnormal_force = \"21.1 N\"\ntangential_ratio = 0.5\n";
    const Case c = parse_case(text, "static.toml");
    EXPECT_EQ(c.load.hold, Case::Load().hold);
    EXPECT_EQ(c.load.press_time, Case::Load().press_time);
    EXPECT_EQ(c.relaxation->bulk, Relaxation().bulk);
}

TEST(RelaxationInput, SectionMayBeWrittenInline) {
    const std::string inlined = "relaxation = {G2 = \"1 MPa\", eta = \"40 Pa s\"}\n";
    const std::string dotted = "relaxation.G2 = \"1 MPa\"\nrelaxation.eta = \"40 Pa s\"\n";
    EXPECT_EQ(write_case(parsed(inlined)), write_case(parsed(standard)));
    EXPECT_EQ(write_case(parsed(dotted)), write_case(parsed(standard)));
}

TEST(RelaxationInput, ResolvedCaseIsTheSeriesInSiUnits) {
    const std::string text = write_case(parsed(standard));
    EXPECT_NE(text.find("\n[substrate.relaxation]\nmoduli = [\"1e+06 Pa\"]\n"
                        "times = [\"4e-05 s\"]\nmodulus = \"relaxed\"\nbulk = \"proportional\"\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("press_time = \"0.5 s\"\nhold = \"60 s\"\n"), std::string::npos) << text;
    EXPECT_NE(text.find("speed = \"0.001 m/s\"\n"), std::string::npos) << text;
    const Case back = parse_case(text, "resolved.toml");
    expect_same(parsed(standard), back);
    EXPECT_EQ(write_case(back), text);
}

// A program that makes a case by itself has only `relaxation`.
TEST(RelaxationInput, ResolvedCaseFollowsTheRelaxationItself) {
    Case c = parsed(standard);
    c.relaxation->branches = {{0.5, 3}, {0.25, 40}};
    const Case back = parse_case(write_case(c), "resolved.toml");
    ASSERT_EQ(back.relaxation->branches.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_DOUBLE_EQ(back.relaxation->branches[i].ratio, c.relaxation->branches[i].ratio);
        EXPECT_EQ(back.relaxation->branches[i].time, c.relaxation->branches[i].time);
    }
    c.relaxation.reset();
    EXPECT_EQ(write_case(c).find("substrate.relaxation"), std::string::npos);
}

TEST(RelaxationInput, Overrides) {
    EXPECT_DOUBLE_EQ(
        parsed(standard, {"substrate.relaxation.G2=3.4 MPa"}).relaxation->branches[0].ratio, 2);
    const Case series = parsed(standard, {"substrate.relaxation.moduli=[\"1 MPa\", \"2 MPa\"]",
                                          "substrate.relaxation.times=[\"1 s\", \"2 s\"]"});
    EXPECT_EQ(series.relaxation->branches.size(), 2U);
    const Case opened =
        parsed("", {"substrate.relaxation.G2=1 MPa", "substrate.relaxation.eta=40 Pa s"});
    expect_same(opened, parsed(standard));
    EXPECT_EQ(message_of(head + standard + tail, {"substrate.relaxation.G3=1 MPa"}),
              "--set substrate.relaxation.G3=1 MPa: unknown key substrate.relaxation.G3; did you "
              "mean substrate.relaxation.G2?");
    EXPECT_EQ(message_of(head + standard + tail, {"substrate.relaxation=1"}),
              "--set substrate.relaxation=1: substrate.relaxation = 1: this is the name of a "
              "section, not of a key; write [substrate.relaxation] on its own line and its keys "
              "below");
}

TEST(RelaxationInput, MisspeltSectionsAreFound) {
    EXPECT_EQ(message_of(head + "[substrate.relaxtion]\nG2 = \"1 MPa\"\n" + tail),
              "relaxing.toml:7:12: unknown section [substrate.relaxtion]; did you mean "
              "substrate.relaxation?");
    EXPECT_EQ(message_of(head + "[substrate.relaxation.more]\nG2 = \"1 MPa\"\n" + tail),
              "relaxing.toml:7:23: unknown section [substrate.relaxation.more]; did you mean "
              "substrate.relaxation?");
}

TEST(RelaxationInput, ElasticBulkIsTheSameAtHalfAndNothingForMdrBelow) {
    const std::string elastic = standard + "bulk = \"elastic\"\n";
    EXPECT_EQ(parsed(elastic).relaxation->bulk, Relaxation::Bulk::elastic);
    EXPECT_NE(message_of(head + elastic + tail,
                         {"substrate.poisson=0.49", "contact.coupling=false", "models=[\"mdr\"]"})
                  .find("below poisson = 0.5 shear then relaxes without the bulk"),
              std::string::npos);
    EXPECT_EQ(
        message_of(head + standard + tail, {"substrate.poisson=0.49", "contact.coupling=false"}),
        "accepted");
}

TEST(RelaxationInput, QuotientsBeyondDoublePrecisionAreRefused) {
    EXPECT_NE(message_of(head + standard + tail, {"substrate.relaxation.G2=1e-300 Pa"})
                  .find("the relaxation time 4e+301 s is out of range"),
              std::string::npos);
    EXPECT_NE(message_of(head + standard + tail,
                         {"substrate.relaxation.G2=1e-310 Pa",
                          "substrate.relaxation.eta=1e-310 Pa s", "substrate.young=1e15 Pa"})
                  .find("out of proportion to the relaxed shear modulus"),
              std::string::npos);
}

class DmaCase : public testing::Test {
  protected:
    // A table of the solid 2 MPa (1 + 0.7 exp(-t/0.05 s) + 0.4 exp(-t/2 s)).
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) / (std::string("io_") + test->name());
        std::filesystem::create_directories(folder_);
        const Relaxation solid{.branches = {{0.7, 0.05}, {0.4, 2}},
                               .bulk = Relaxation::Bulk::proportional};
        std::ofstream file(folder_ / "rubber.csv");
        file.precision(17);
        file << "frequency [Hz], G' [MPa], G'' [MPa]\n";
        for (int k = -8; k <= 8; ++k) {
            const double frequency = std::pow(10., k / 4.);
            const auto modulus = 2. * solid.dynamic_ratio(2 * std::numbers::pi * frequency);
            file << frequency << ", " << modulus.real() << ", " << modulus.imag() << '\n';
        }
    }

    Case read(const std::vector<std::string>& overrides = {}) const {
        return parse_case(head + "[substrate.relaxation]\ndma = \"rubber.csv\"\n" + tail,
                          (folder_ / "case.toml").string(), overrides);
    }

    std::filesystem::path folder_;
};

TEST_F(DmaCase, TakesTheShapeOfTheTableAndTheModulusOfTheCase) {
    const Case c = read();
    ASSERT_TRUE(relaxation_fits(c).dma);
    EXPECT_EQ(relaxation_fits(c).dma->table.name, "rubber.csv");
    ASSERT_EQ(c.relaxation->branches.size(), 2U);
    // Numbers of 17 digits, recovered as in contact_dma_fit.cc.
    EXPECT_NEAR(relaxation_fits(c).dma->relaxed_modulus, 2e6, 2e6 * 1e-9);
    EXPECT_NEAR(c.relaxation->branches[0].ratio, 0.7, 1e-9);
    EXPECT_NEAR(c.relaxation->branches[1].ratio, 0.4, 1e-9);
    EXPECT_NEAR(c.relaxation->branches[0].time, 0.05, 1e-10);
    EXPECT_NEAR(c.relaxation->branches[1].time, 2, 1e-9);
    // The case has 1.7 MPa.
    EXPECT_NEAR(c.of<io::RelaxationInput>().moduli[0], 0.7 * 1.7e6, 1e-2);
    EXPECT_EQ(contact::remarks(*relaxation_fits(c).dma, c.substrate.shear_modulus()).size(), 2U);
}

TEST_F(DmaCase, ResolvedCaseStandsWithoutTheTable) {
    const Case c = read();
    const std::string text = write_case(c);
    EXPECT_EQ(text.find("dma"), std::string::npos) << text;
    const Case back = parse_case(text, "/elsewhere/resolved.toml");
    expect_same(c, back);
    EXPECT_EQ(write_case(back), text);
}

TEST_F(DmaCase, OverridingTheTableMeansTheWorkingDirectory) {
    EXPECT_THROW(read({"substrate.relaxation.dma=rubber.csv"}), contact::InputError);
    EXPECT_EQ(read({"substrate.relaxation.dma=" + (folder_ / "rubber.csv").string()})
                  .relaxation->branches.size(),
              2U);
    const Case solid = read({"substrate.relaxation.G2=1 MPa", "substrate.relaxation.eta=40 Pa s"});
    expect_same(solid, parsed(standard));
}

}  // namespace
}  // namespace tricontact::io::relaxation_test
