// Heat of both bodies and a layer between them (H = 1, 3, M = 4): read and written.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/heat.h"
#include "contact_program/import.h"
#include "contact_program/sequence.h"
#include "io/case/case_reader.h"

namespace tricontact::contact_program::heat_reading_test {
namespace {

using contact::Case;

std::vector<Case> cases_of(const std::string& text) {
    std::vector<Case> cases;
    for (const ImportedCase& one :
         import_cases(text + " 0 MODULE\n", "file.inp", bem::is_coupled).cases)
        cases.push_back(io::parse_case(one.text, "case.toml"));
    return cases;
}

/// Two steel balls, the layer between them as given, then a second case that keeps all but CKSI.
std::string heated_case(const std::string& layer) {
    return " 3 MODULE\n 203100\n 022420\n 3000110\n 100 100 30 1 1e-6\n 1000 -0.002 0 0\n 0.3 0.3\n"
           " 0 .2 30000\n 0.28 0.28 82000 82000\n " +
           layer +
           "\n 20 450 50e-3 7.85e-6\n 90 800 0.9e-3 2.5e-6\n 1\n 1\n 41 41 -4.1 -4.1 .2 .2\n 1 1\n"
           " .001 0 .001 0 0 0\n 203100\n 100400\n 1100111\n 1000 -0.004 0 0\n";
}

const std::string rolled_sphere =
    "models = [\"bem\"]\n[indenter]\nradius = \"40 mm\"\nyoung = \"210 GPa\"\npoisson = 0.28\n"
    "[substrate]\nyoung = \"210 GPa\"\npoisson = 0.28\n[load]\nnormal_force = \"100 N\"\n"
    "[bem]\ncells_per_radius = 5\n[tractive_rolling]\nlongitudinal_creepage = 0.001\n"
    "speed = \"20 m/s\"\n[friction]\ncoefficient = 0.3\n";

TEST(ImportedHeat, HeatAndALayerBetweenTheBodies) {
    const auto cases = cases_of(heated_case("8200 1.25 0 0"));
    ASSERT_EQ(cases.size(), 2U);
    EXPECT_DOUBLE_EQ(*cases[1].tractive_rolling->longitudinal_creepage, -.004);
    for (const Case& c : cases) {
        const auto& heat = c.of<contact::ContactHeat>();
        EXPECT_DOUBLE_EQ(heat.indenter.conductivity, 50);
        EXPECT_DOUBLE_EQ(heat.indenter.density, 7850);
        EXPECT_EQ(heat.indenter.temperature, 20);
        EXPECT_EQ(heat.substrate.specific_heat, 800);
        EXPECT_DOUBLE_EQ(heat.substrate.conductivity, .9);
        EXPECT_EQ(heat.substrate.temperature, 90);
        EXPECT_DOUBLE_EQ(c.tractive_rolling->speed, 30);
        EXPECT_DOUBLE_EQ(*c.interface.tangential_stiffness, 6.56e12);  // 6560 N/mm^3
        EXPECT_FALSE(c.interface.normal_stiffness);
    }
    const auto without = cases_of(heated_case("8200 0 0 0"));
    EXPECT_FALSE(without.at(0).interface.is_elastic());
    const auto yielding = cases_of(heated_case("8200 1.25 300 0"));
    EXPECT_DOUBLE_EQ(yielding.at(0).friction.yield->stress, 3e8);
    EXPECT_EQ(yielding.at(0).friction.yield->hardening, 0);
    EXPECT_THROW(cases_of(heated_case("8200 1.25 300 5")), contact::InputError);  // it rolls on
}

TEST(ImportedHeat, WrittenHeatAndLayerComeBack) {
    const Case c = io::parse_case(rolled_sphere + R"toml([indenter.heat]
conductivity = "50 W/(m K)"
specific_heat = "450 J/(kg K)"
density = "7850 kg/m3"
temperature = "-20 degC"
[substrate.heat]
conductivity = "0.9 W/(m K)"
specific_heat = "800 J/(kg K)"
density = "2500 kg/m3"
[interface]
tangential_stiffness = "6560 MPa/mm"
)toml",
                                  "heat.toml");
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    const auto back =
        cases_of(sequence_text(c, compliance->points(), compliance->is_coupled(), {}));
    const auto &given = c.of<contact::ContactHeat>(),
               &heat = back.back().of<contact::ContactHeat>();
    for (const auto& [a, b] : {std::pair{&given.indenter, &heat.indenter},
                               std::pair{&given.substrate, &heat.substrate}}) {
        EXPECT_DOUBLE_EQ(a->effusivity(), b->effusivity());
        EXPECT_DOUBLE_EQ(a->diffusivity(), b->diffusivity());
        EXPECT_EQ(a->temperature, b->temperature);
    }
    EXPECT_DOUBLE_EQ(*back.back().interface.tangential_stiffness, 6.56e12);
    EXPECT_DOUBLE_EQ(back.back().tractive_rolling->speed, c.tractive_rolling->speed);
    Case stiff = c;
    stiff.interface.normal_stiffness = 1e12;
    EXPECT_THROW(sequence_text(stiff, compliance->points(), compliance->is_coupled(), {}),
                 contact::InputError);
}

TEST(ImportedHeat, FrictionByTheTemperature) {
    const auto text_of = [](const std::string& law) {
        std::string text = heated_case("8200 0 0 0");
        text.replace(text.find("022420"), 6, "622420");
        text.replace(text.find("0.3 0.3"), 7, law);
        return text;
    };
    const auto read = cases_of(text_of("0.3 20 -0.18 380\n 0 1"));
    ASSERT_EQ(read.size(), 2U);
    for (const Case& c : read) {
        const auto& law = *c.friction.temperature;
        EXPECT_EQ(*c.friction.coefficient, .3);
        EXPECT_EQ(law.change, -.18);
        EXPECT_EQ(law.from, 20);
        EXPECT_EQ(law.to, 400);
    }
    EXPECT_FALSE(cases_of(text_of("0.3 20 0 380\n 0 1")).at(0).friction.temperature);
    EXPECT_THROW(cases_of(text_of("0.3 20 -0.18 380\n 0.003 1")), contact::InputError);

    // What is written of it comes back.
    const Case& c = read.at(0);
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    const auto back =
        cases_of(sequence_text(c, compliance->points(), compliance->is_coupled(), {}));
    ASSERT_EQ(back.size(), 1U);
    const auto& law = *back[0].friction.temperature;
    EXPECT_EQ(law.change, -.18);
    EXPECT_EQ(law.to, 400);
    EXPECT_EQ(*back[0].friction.coefficient, .3);
    EXPECT_EQ(back[0].of<contact::ContactHeat>().substrate.temperature, 90);
}

}  // namespace
}  // namespace tricontact::contact_program::heat_reading_test
