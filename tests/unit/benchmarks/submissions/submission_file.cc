#include "benchmarks/submissions/submission_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "benchmarks/submissions/dat_totals.h"
#include "benchmarks/submissions/read_field.h"
#include "benchmarks/submissions/total_keys.h"
#include "contact/base/error.h"
#include "tests/paths.h"

namespace tricontact::benchmarks::submission_file_test {
namespace {

const std::string foreign = paths::source("tests/benchmarks/foreign/");

Submission submission_of(const std::string& text) {
    return parse_submission(text, foreign + "a.toml");
}

std::string message_of(const std::string& text) {
    try {
        submission_of(text);
    } catch (const contact::InputError& error) {
        const std::string what = error.what();
        return what.starts_with(foreign) ? what.substr(foreign.size()) : what;
    }
    return "accepted";
}

const std::string good = R"(case = "layer_pressed"
code = "CalculiX 2.20"
elements = "CAX8R"
block_width = "48 mm"
[contact]
method = "penalty"
stiffness = "260 MPa/mm"
kinematics = "displaced"
press_steps = 5
[tolerance]
default = 0.02
peak_pressure = 0.05
[[mesh]]   # coarse
size = "1 mm"
field = "calculix_cax8r_1.frd"
cpu_time = "2 min"
[[mesh]]
size = "0.5 mm"
field = "calculix_cax8r_0.5.frd"
totals = "calculix_cax8r_0.5.dat"
normal_force = "16.7 N"
)";

TEST(SubmissionFile, SaysWhatAReaderCannotSee) {
    const Submission s = submission_of(good);
    EXPECT_EQ(s.problem, "layer_pressed");
    EXPECT_EQ(s.code, "CalculiX 2.20");
    EXPECT_EQ(s.elements, "CAX8R");
    EXPECT_DOUBLE_EQ(s.block_width.value(), .048);
    EXPECT_EQ(s.contact.kind, ContactMethod::Kind::penalty);
    EXPECT_EQ(s.contact.kinematics, ContactMethod::Kinematics::displaced);
    EXPECT_DOUBLE_EQ(s.contact.stiffness.value(), 260e9);
    EXPECT_FALSE(s.contact.stick_slope);
    EXPECT_EQ(s.contact.press_steps, 5);
    EXPECT_EQ(s.tolerances.at("normal_force"), .02);
    EXPECT_EQ(s.tolerances.at("peak_pressure"), .05);
    ASSERT_EQ(s.meshes.size(), 2U);
    EXPECT_EQ(s.meshes[0].totals.at("cpu_time").value, 120);
    EXPECT_EQ(s.meshes[1].totals.at("normal_force").value, 16.7);
    EXPECT_EQ(s.meshes[1].totals.at("normal_force").place, foreign + "a.toml:21:16");
    EXPECT_TRUE(s.meshes[1].totals.contains(balancing_force));
}

TEST(SubmissionFile, AMeshMayBeNumbersAlone) {
    const Submission s =
        submission_of("case = \"x.toml\"\n[[mesh]]\nsize = \"1 mm\"\nnormal_force = \"16.7 N\"\n");
    EXPECT_EQ(s.problem, foreign + "x.toml") << "beside the submission";
    EXPECT_EQ(s.meshes[0].size(), 0U);
    EXPECT_EQ(s.tolerances.usual, .01);
}

TEST(SubmissionFile, IsRefusedLikeACase) {
    const auto expect = [](const std::string& text, const std::string& message) {
        EXPECT_EQ(message_of(text).substr(0, message.size()), message);
    };
    const std::string head = "case = \"a\"\n", mesh = "[[mesh]]\nnormal_force = \"1 N\"\n";
    expect("", "a.toml:1:1: the file is empty");
    expect("case = \"a\"\n", "a.toml:1:1: names no results; add [[mesh]]");
    expect(mesh, "a.toml:1:1: missing key case");
    expect(head + "cod = \"b\"\n" + mesh, "a.toml:2:1: unknown key cod; did you mean code?");
    expect(head + "[contact]\nstiffnes = \"1 MPa/mm\"\n" + mesh,
           "a.toml:3:1: unknown key contact.stiffnes; did you mean contact.stiffness?");
    expect(head + "[contact]\nstiffness = \"260 MPa\"\n" + mesh,
           R"(a.toml:3:13: contact.stiffness = "260 MPa": "MPa" is a unit of pressure)");
    expect(head + "[contact]\nstiffness = 260\n" + mesh,
           "a.toml:3:13: contact.stiffness = 260: must be a pressure per length, but has no unit");
    expect(head + "[contact]\nmethod = \"penality\"\n" + mesh,
           R"(a.toml:3:10: contact.method = "penality": "penality" is not one of)");
    expect(head + "[contact]\npress_steps = 0\n" + mesh, "a.toml:3:15: contact.press_steps = 0: ");
    expect(head + "[tolerance]\npeak_presure = 0.1\n" + mesh,
           "a.toml:3:1: unknown key tolerance.peak_presure; did you mean tolerance.peak_pressure?");
    expect(head + "[tolerance]\ndefault = 0\n" + mesh, "a.toml:3:11: tolerance.default = 0: ");
    expect(head + "[tolerances]\ndefault = 0.1\n" + mesh,
           "a.toml:2:1: unknown section [tolerances]; did you mean tolerance?");
    expect(head + "[mesh]\nnormal_force = \"1 N\"\n", "a.toml:2:1: [mesh]: meshes form a list");
    expect(head + "[[mesh]]\nnormal_force = \"1\"\n",
           R"(a.toml:3:16: mesh.normal_force = "1": the unit is missing)");
    expect(head + "[[mesh]]\nnormal_force = 1\n",
           "a.toml:3:16: mesh.normal_force = 1: a number with a unit is due");
    expect(head + "[[mesh]]\nsze = \"1 mm\"\n", "a.toml:3:1: unknown key mesh.sze; did you mean");
    expect(head + "[[mesh]]\nsize = \"1 mm\"\n", "a.toml:2:1: [[mesh]]: has nothing to compare");
    expect(head + "[[mesh]]\nfield = \"none.csv\"\n", "none.csv: the file cannot be read");
    expect(head + "[[mesh]]\nfield = \"layer_pressed.toml\"\n",
           "layer_pressed.toml: unknown kind of file");
    expect(head + "[[mesh]]\nset = \"A\"\nnormal_force = \"1 N\"\n",
           R"(a.toml:3:7: mesh.set = "A": has no effect without mesh.field)");
    expect(head +
               "[[mesh]]\nsize = \"1 mm\"\nshift = \"1 mm\"\n[[mesh]]\nsize = \"2 mm\"\n"
               "shift = \"1 mm\"\n",
           "a.toml:5:1: [[mesh]]: meshes stand from coarse to fine");
    std::string many = head;
    for (int i = 0; i < 9; ++i) many += mesh;
    expect(many, "a.toml:18: [[mesh]]: there are more than 8 meshes");
}

TEST(SubmissionFile, PlainFilesAreSortedBySizeOrByTheirPoints) {
    const auto files = [](const Submission& s) {
        std::vector<std::string> names;
        for (const MeshField& mesh : s.meshes) names.push_back(mesh.file.substr(foreign.size()));
        return names;
    };
    EXPECT_EQ(
        files(submission_of_files("a", {foreign + "getfem_q2_0.25.csv", foreign + "getfem_q2_1.csv",
                                        foreign + "getfem_q2_0.5.csv"})),
        (std::vector<std::string>{"getfem_q2_1.csv", "getfem_q2_0.5.csv", "getfem_q2_0.25.csv"}));
    EXPECT_EQ(files(submission_of_files(
                  "a", {foreign + "calculix_cax8r_0.5.frd", foreign + "calculix_cax8r_1.frd"})),
              (std::vector<std::string>{"calculix_cax8r_1.frd", "calculix_cax8r_0.5.frd"}));
    EXPECT_THROW(submission_of_files("a", {}), contact::InputError);
    EXPECT_THROW(submission_of_files("a", std::vector<std::string>(9, foreign + "a.csv")),
                 contact::InputError);
    // Points of r = 0, 0.5 ... 4.5 mm carry load there: nine distances.
    const double distance =
        relative_point_distance(read_field({foreign + "freefem_p2_1.csv", "", ""}));
    EXPECT_NEAR(distance, .5 / 4, .02);
}

TEST(SubmissionFile, DocumentHasAllKeys) {
    std::ifstream in(paths::source("docs/reference/benchmark-submission.md"));
    std::stringstream text;
    text << in.rdbuf();
    const std::string document = text.str();
    for (const TotalKey& key : total_keys()) {
        EXPECT_NE(document.find("| `" + std::string(key.key) + "` |"), std::string::npos)
            << key.key;
        EXPECT_NE(document.find("| `" + std::string(key.example) + "` |"), std::string::npos);
        for (const auto other : key.also)
            EXPECT_NE(document.find('`' + std::string(other) + '`'), std::string::npos) << other;
    }
    for (const io::Key* key : submission_keys().keys()) {
        if (key->path.starts_with("tolerance.") && key->path != "tolerance.default") continue;
        const std::string_view path =
            key->path.starts_with("mesh.") ? key->path.substr(5) : key->path;
        EXPECT_NE(document.find("| `" + std::string(path) + "` |"), std::string::npos) << path;
    }
}

}  // namespace
}  // namespace tricontact::benchmarks::submission_file_test
