#include "runs/unread_parts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace tricontact::unread_parts_test {
namespace {

/// What a command that reads `reads` says of a case with a rig's parts.
std::string said(const std::optional<std::vector<std::string>>& reads, bool quiet = false) {
    const auto path = std::filesystem::temp_directory_path() / "tricontact_unread_parts.toml";
    std::ofstream(path) << "[indenter]\nradius = \"40 mm\"\n[substrate]\nyoung = \"5 ± 0.1 MPa\"\n"
                           "[rig]\nsides = 1\n[printed]\nnote = 1\n";
    std::string text;
    runs::CommandOptions options;
    options.file = path.string();
    options.reads = reads;
    options.quiet = quiet;
    options.listener = std::make_shared<runs::Listener>(
        runs::Listener{.out = nullptr,
                       .say = [&](const std::string& line) { text += line + '\n'; },
                       .progress = {}});
    runs::say_unread_parts(options, "run");
    std::filesystem::remove(path);
    return text;
}

TEST(UnreadParts, NamesPartsAndTheirReaders) {
    const std::string text = said(std::vector<std::string>{});
    EXPECT_NE(text.find("not read by run: "), std::string::npos) << text;
    EXPECT_NE(text.find("[rig] (read by rig, design, identify, experiment with loops)"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("[printed] (read by rig)"), std::string::npos) << text;
    EXPECT_NE(text.find("± of the numbers (read by predict --samples"), std::string::npos) << text;
}

TEST(UnreadParts, AreNotThoseThatTheCommandReads) {
    const std::string text = said(std::vector<std::string>{"[rig]", "[printed]"});
    EXPECT_EQ(text.find("[rig]"), std::string::npos) << text;
    EXPECT_NE(text.find("± of the numbers"), std::string::npos) << text;
}

// Of a command that takes no case file, and of a quiet one, nothing is said.
TEST(UnreadParts, AreOfCommandsOnCases) {
    EXPECT_EQ(said(std::nullopt), "");
    EXPECT_EQ(said(std::vector<std::string>{}, true), "");
}

}  // namespace
}  // namespace tricontact::unread_parts_test
