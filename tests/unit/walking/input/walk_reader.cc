#include "walking/input/walk_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "tests/paths.h"
#include "tests/unit/walking/sets.h"
#include "walking/input/walk_keys.h"
#include "walking/machine/linear_stability.h"

namespace tricontact::walking::walk_reader_test {
namespace {

const std::string cases = paths::source("examples/cases/");

const std::string kappas = R"([machine]
kappa1 = 2
kappa2 = 1.2
kappa3 = 0.5
kappa4 = 1e-4
kappa5 = 0.68
kappa6 = 1e-4
kappa7 = 0.42
kappa8 = 1.18
)";

const std::string dimensions = R"([machine]
mass = "490 g"
half_height = "21.2 mm"
half_width = "14 mm"
moment_of_inertia = "1.7e-4 kg m2"
spring_stiffness = "4.34e6 N/m"
friction_coefficient = 0.75
base_velocity = "40 mm/s"
)";

WalkCase parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_walk_case(text, "test.toml", overrides);
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        parsed(text, overrides);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

TEST(WalkReader, ReadsTheSetsOfTheThesis) {
    const WalkCase a = read_walk_case(cases + "walking_set_a.toml");
    const WalkCase b = read_walk_case(cases + "walking_set_b.toml");
    EXPECT_EQ(a.machine, (Machine{.kappas = walking::set_a()}));
    EXPECT_EQ(b.machine, (Machine{.kappas = walking::set_b()}));
    EXPECT_EQ(b.start, Start{});
    EXPECT_EQ(b.time, (WalkCase::Time{1e-3, 20000}));
    EXPECT_FALSE(b.dimensional);
}

TEST(WalkReader, FillsInWhatIsLeftOpen) {
    const WalkCase c = parsed(kappas);
    EXPECT_EQ(c.machine, (Machine{.kappas = walking::set_b()}));
    EXPECT_EQ(c.time, WalkCase::Time{});
    EXPECT_EQ(c.start, Start{});
}

// Wetter (2016), tables 4.3.2 and 5.2.1, as printed: to the digits there.
TEST(WalkReader, KappasOfTheRigFollowFromMaterialsAndDimensions) {
    const WalkCase c = read_walk_case(cases + "walking_rig_set_5.toml");
    EXPECT_EQ(c.machine.model, Machine::Model::prism);
    EXPECT_NEAR(c.machine.kappas.kappa1, 2, 0.05);
    EXPECT_NEAR(c.machine.kappas.kappa2, 1.33, 0.005);
    EXPECT_NEAR(c.machine.kappas.kappa3, 1.51, 0.005);
    EXPECT_NEAR(c.machine.kappas.kappa4, 2e-4, 0.5e-4);
    EXPECT_EQ(c.machine.kappas.kappa5, 0.75);
    EXPECT_NEAR(c.machine.kappas.kappa7, 1.77, 0.005);
    EXPECT_NEAR(c.machine.kappas.kappa8, -0.47, 1e-15);
    ASSERT_TRUE(c.dimensional);
    EXPECT_NEAR(c.dimensional->tangential_stiffness, 2.2e6, 0.05e6);
    EXPECT_NEAR(c.dimensional->lever_arm, -0.47 * 21.2e-3, 1e-15);
    EXPECT_EQ(c.dimensional->gravity, 9.81);
    EXPECT_NEAR(c.time.end * characteristic_time(*c.dimensional), 5, 1e-12);
}

// Wetter (2016), eq. 4.1.8: E* = 2G/(1 - nu), G* = 4G/(2 - nu) on a rigid substrate; of equal
// bodies half of each.
TEST(WalkReader, StiffnessesFollowFromTheContact) {
    const std::string contact =
        "height_ratio = 0.5\n[contact]\ndiameter = \"2 mm\"\nyoung = \"3 GPa\"\npoisson = 0.2\n";
    const double shear = 3e9 / (2 * 1.2), diameter = 2e-3, rounding = 1e-14;
    const WalkCase rigid = parsed(dimensions + contact);
    EXPECT_NEAR(rigid.dimensional->normal_stiffness / (2 * shear / 0.8 * diameter), 1, rounding);
    EXPECT_NEAR(rigid.dimensional->tangential_stiffness / (4 * shear / 1.8 * diameter), 1,
                rounding);
    const WalkCase equal =
        parsed(dimensions + contact + "substrate_young = \"3 GPa\"\nsubstrate_poisson = 0.2\n");
    EXPECT_NEAR(rigid.dimensional->normal_stiffness / equal.dimensional->normal_stiffness, 2,
                rounding);
    EXPECT_NEAR(rigid.dimensional->tangential_stiffness / equal.dimensional->tangential_stiffness,
                2, rounding);
}

TEST(WalkReader, StatedStiffnessesAndLeverArmAreTaken) {
    const WalkCase c = parsed(dimensions +
                              "tangential_stiffness = \"2 N/um\"\nnormal_stiffness = \"3 N/um\"\n"
                              "lever_arm = \"-10.6 mm\"\ngravity = \"1.62 m/s2\"\n");
    EXPECT_EQ(c.dimensional->tangential_stiffness, 2e6);
    EXPECT_EQ(c.dimensional->normal_stiffness, 3e6);
    EXPECT_EQ(c.machine.kappas.kappa2, 1.5);
    EXPECT_NEAR(c.machine.kappas.kappa8, -0.5, 1e-15);
    EXPECT_NEAR(c.machine.kappas.kappa4, 0.49 * 1.62 / (2e6 * 14e-3), 1e-18);
}

TEST(WalkReader, OverridesTakeAlternativesAway) {
    const std::string file = cases + "walking_rig_set_5.toml";
    const WalkCase stated = read_walk_case(
        file, {"machine.tangential_stiffness=2e6 N/m", "machine.normal_stiffness=3e6 N/m",
               "machine.lever_arm=10.6 mm", "time.end=50"});
    EXPECT_FALSE(stated.input.contact);
    EXPECT_FALSE(stated.input.height_ratio);
    EXPECT_EQ(stated.time.end, 50);
    EXPECT_NEAR(stated.machine.kappas.kappa8, 0.5, 1e-15);
}

TEST(WalkReader, SpotsStandAnywhere) {
    const WalkCase c =
        parsed("[spots]\npositions = [-1, 0.25, 1]\nheights = [0, 2e-5, 0]\n" + kappas,
               {"machine.model=spots"});
    const std::vector<Spot> due{{-1, 0, 1}, {0.25, 2e-5, 1}, {1, 0, 1}};
    EXPECT_EQ(c.machine.spots, due);
}

TEST(WalkReader, WithoutFrictionIsALimitCase) {
    EXPECT_EQ(parsed(kappas, {"machine.kappa5=0"}).machine.kappas.kappa5, 0);
}

TEST(WalkReader, StepMayApproachTheStableLimit) {
    const double stable = stable_step({.kappas = walking::set_b()});
    EXPECT_EQ(message_of(kappas, {"time.step=" + std::to_string(0.999 * stable)}), "(accepted)");
    EXPECT_NE(message_of(kappas, {"time.step=" + std::to_string(1.001 * stable)})
                  .find("exceeds the stable limit 0.6828 of velocity Verlet"),
              std::string::npos);
}

TEST(WalkReader, KindsOfCasesAreTold) {
    EXPECT_TRUE(
        std::holds_alternative<WalkCase>(walking::read_any_case(cases + "walking_set_a.toml")));
    EXPECT_TRUE(std::holds_alternative<contact::Case>(
        walking::read_any_case(cases + "rig_sphere_parallel.toml")));
    EXPECT_EQ(message_of("models = [\"mdr\"]\n"),
              "test.toml:1:1: missing section [machine]: no case of the walking machine; "
              "add a section [machine] with its kappas");
    EXPECT_EQ(message_of("models = [\"mdr\"]\n[indenter]\n"),
              "test.toml:2:1: this is a contact case, not a case of the micro-walking machine; "
              "tricontact run computes it");
}

// What a key needs beside its example to be accepted.
std::vector<std::string> companions(const WalkKey& key) {
    if (key.section() == "spots") return {"machine.model=spots", "spots.positions=[-1, 0, 1]"};
    if (key.section() == "bed") return {"bed.radius=0.5"};
    if (key.path == "excitation.frequency") return {"excitation.force=1e-5"};
    if (key.section() == "excitation") return {"excitation.frequency=1.5"};
    if (key.path == "machine.model") return {};
    if (!is_dimensional(key)) return {};
    std::vector<std::string> all{"machine.height_ratio=0.5"};
    if (key.section() == "contact")
        for (const char* one :
             {"contact.diameter=2 mm", "contact.young=3 GPa", "contact.poisson=0.3",
              "contact.substrate_young=90 GPa", "contact.substrate_poisson=0.3"})
            all.emplace_back(one);
    else
        for (const char* one :
             {"machine.tangential_stiffness=2e6 N/m", "machine.normal_stiffness=3e6 N/m"})
            all.emplace_back(one);
    return all;
}

TEST(WalkKeys, EveryKeyHasAMeaningAndAnExampleThatIsAcceptedAndWritten) {
    for (const WalkKey& key : walk_keys()) {
        EXPECT_FALSE(key.text.empty()) << key.path;
        const std::string path(key.path);
        std::vector<std::string> overrides = companions(key);
        std::erase_if(overrides, [&](const std::string& one) {
            return one.starts_with(path + '=') ||
                   (path == "machine.lever_arm" && one.starts_with("machine.height_ratio"));
        });
        overrides.push_back(path + '=' + std::string(key.example));
        const std::string& text = is_dimensional(key) ? dimensions : kappas;
        ASSERT_EQ(message_of(text, overrides), "(accepted)") << key.path;
        const std::string written = walking::write_walk_case(parsed(text, overrides));
        EXPECT_NE(('\n' + written).find('\n' + std::string(key.name()) + " = "), std::string::npos)
            << key.path << " is not in\n"
            << written;
        EXPECT_EQ(walking::write_walk_case(parsed(written)), written);
    }
}

TEST(WalkWriter, ReadsBackTheSame) {
    for (const char* name : {"walking_set_a", "walking_set_b", "walking_rig_set_5"}) {
        const WalkCase c = read_walk_case(cases + name + ".toml");
        const WalkCase back = parsed(walking::write_walk_case(c));
        EXPECT_EQ(back.machine, c.machine);
        EXPECT_EQ(back.time, c.time);
        EXPECT_EQ(back.start, c.start);
        EXPECT_EQ(back.title, c.title);
        EXPECT_EQ(back.frames, c.frames);
    }
}

}  // namespace
}  // namespace tricontact::walking::walk_reader_test
