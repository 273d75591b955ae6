#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "contact/base/error.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/records/experiment.h"
#include "io/case/case_reader.h"
#include "io/case/rig_file.h"
#include "io/case/study_reader.h"
#include "io/keys/key_checks.h"
#include "tests/paths.h"
#include "walking/input/walk_keys.h"
#include "walking/input/walk_reader.h"

namespace tricontact::io::file_kind_test {
namespace {

std::string message(const std::function<void()>& read) {
    try {
        read();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return {};
}

// What every reader says to a file of this repository; empty: it takes it.
const std::map<std::string, std::function<void(const std::string&)>>& readers() {
    static const std::map<std::string, std::function<void(const std::string&)>> all{
        {"run", [](const std::string& path) { read_case(path); }},
        {"check", [](const std::string& path) { walking::read_any_case(path); }},
        {"walk", [](const std::string& path) { walking::read_walk_case(path); }},
        {"sweep", [](const std::string& path) { read_study(path, walking::walk_key_list()); }},
        {"rig", [](const std::string& path) { read_rig_file(path); }},
        {"experiment", [](const std::string& path) { experiments::read_experiment(path); }},
        {"identify", [](const std::string& path) { experiments::read_identification(path); }}};
    return all;
}

// Whether a file leaves out what is to be found from its measurements.
bool leaves_something_out(const std::filesystem::path& file) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return text.find("\nfind = ") != std::string::npos;
}

// What the file at hand is for: a study, or one of the kinds of case, all computed by run.
std::string command_for(const std::filesystem::path& file) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string folder = file.parent_path().filename();
    if (folder == "studies") return "sweep";
    if (text.find("[machine]") != std::string::npos) return "walk";
    return text.find("[tractive_rolling]") != std::string::npos ? "roll" : "run";
}

// Take any contact case, and say what it lacks.
const std::set<std::string> of_rigs{"rig", "experiment", "identify"};

TEST(FileKind, EveryFileGivenToAnotherCommandNamesItsOwn) {
    int n = 0;
    for (const char* folder : {"cases", "studies", "rigs", "records", "measurements"})
        for (const auto& entry :
             std::filesystem::directory_iterator(paths::source("examples/") + folder)) {
            if (entry.path().extension() != ".toml") continue;
            const std::string command = command_for(entry.path());
            for (const auto& [reader, read] : readers()) {
                if (leaves_something_out(entry.path()) && (reader == "run" || reader == "check"))
                    continue;
                if (of_rigs.contains(reader) && command != "sweep" && command != "walk") continue;
                const std::string said = message([&] { read(entry.path().string()); });
                const bool takes = reader == command || (reader == "run" && command == "roll") ||
                                   (reader == "check" &&
                                    (command == "run" || command == "roll" || command == "walk"));
                if (takes)
                    EXPECT_EQ(said, "") << reader << ' ' << entry.path();
                else
                    EXPECT_NE(
                        said.find(command == "sweep" ? "; tricontact sweep " : "; tricontact run "),
                        std::string::npos)
                        << reader << ' ' << entry.path() << ": " << said;
                ++n;
            }
        }
    EXPECT_GT(n, 300);
}

TEST(FileKind, SaysWhatItIsAndWhatIsDue) {
    EXPECT_EQ(message([] { parse_case("[set]\nload.tangential_ratio = 0.3\n", "a.toml"); }),
              "a.toml:1:1: this is a study, not a contact case; tricontact sweep computes it");
    EXPECT_EQ(message([] { parse_rig_file("[machine]\n", "a.toml"); }),
              "a.toml:1:1: this is a case of the micro-walking machine, not a contact case; "
              "tricontact run computes it");
    EXPECT_EQ(message([] { parse_case(" 3 MODULE\n", "a.inp"); }),
              "a.inp: this is input of the program CONTACT; tricontact contact import makes a case "
              "of it");
}

TEST(FileKind, AnOverrideDoesNotChangeIt) {
    const std::string path = paths::source("examples/cases/rig_sphere_parallel.toml");
    EXPECT_NE(
        message([&] { read_case(path, {"rig=rolling"}); }).find("this is the name of a section"),
        std::string::npos);
}

TEST(LikelyPath, KnowsSymbolsOfTextbooks) {
    const std::vector<std::string_view> known{
        "indenter.young",    "indenter.radius",        "substrate.young",   "substrate.poisson",
        "substrate.base",    "friction.coefficient",   "load.normal_force", "load.tangential_ratio",
        "rolling.amplitude", "rolling.amplitude_ratio"};
    for (const auto& [path, due] :
         std::map<std::string, std::string>{{"substrate.E", "substrate.young"},
                                            {"substrate.nu", "substrate.poisson"},
                                            {"substrate.youngs_modulus", "substrate.young"},
                                            {"substrate.poisson_ratio", "substrate.poisson"},
                                            {"substrate.yuong", "substrate.young"},
                                            {"indenter.E", "indenter.young"},
                                            {"indenter.R", "indenter.radius"},
                                            {"friction.mu", "friction.coefficient"},
                                            {"load.F_N", "load.normal_force"},
                                            {"load.f_T", "load.tangential_ratio"},
                                            {"rolling.w", "rolling.amplitude_ratio"},
                                            {"rolling.W", "rolling.amplitude"},
                                            {"mu", "friction.coefficient"},
                                            {"substrate.coefficient", "friction.coefficient"},
                                            {"substrate.xyz", ""},
                                            {"substrate.q", ""}})
        EXPECT_EQ(likely_path(path, known), due) << path;
}

}  // namespace
}  // namespace tricontact::io::file_kind_test
