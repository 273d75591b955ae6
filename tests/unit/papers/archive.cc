#include "papers/archive.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "contact/base/error.h"
#include "files/version.h"

namespace tricontact::archive_test {
namespace {

using papers::Archive;

Archive example() {
    Archive archive = papers::new_archive();
    archive.calls = {{"run", {"{archive}/inputs/a.toml", "--set", "load.hold=1 s"}}};
    archive.files = {{"inputs/a.toml", "title = \"ä\"\n"},
                     {"results/summary.json", "{}"},
                     {"figures/limit.csv", "x,y\n1,2\n"}};
    return archive;
}

/// A file that goes away with this object.
struct Kept {
    explicit Kept(const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }
    ~Kept() { std::filesystem::remove(path); }
    std::string path =
        (std::filesystem::temp_directory_path() / "tricontact_archive_test.zip").string();
};

std::string why_refused(const std::string& bytes) {
    const Kept kept(bytes);
    try {
        papers::read_archive(kept.path);
    } catch (const contact::InputError& why) {
        return why.what();
    }
    return {};
}

TEST(Archive, ComesBackAsItWasWritten) {
    const Archive written = example();
    const Kept kept(papers::archive_text(written));
    const Archive read = papers::read_archive(kept.path);
    EXPECT_EQ(read.version, files::version);
    EXPECT_EQ(read.numerics, written.numerics);
    EXPECT_EQ(read.libraries, written.libraries);
    ASSERT_EQ(read.calls.size(), 1U);
    EXPECT_EQ(read.calls[0].command, "run");
    EXPECT_EQ(read.calls[0].arguments, written.calls[0].arguments);
    for (const auto& [name, text] : written.files) EXPECT_EQ(read.files.at(name), text);
}

TEST(Archive, IsTheSameBytesAgain) {
    EXPECT_EQ(papers::archive_text(example()), papers::archive_text(example()));
}

TEST(Archive, ComparesResultsAndDataOfFigures) {
    const auto numbers = example().numbers();
    EXPECT_TRUE(numbers.contains("results/summary.json"));
    EXPECT_TRUE(numbers.contains("figures/limit.csv"));
    EXPECT_FALSE(numbers.contains("inputs/a.toml"));
}

// Whatever byte changes is noticed, or changes nothing that is read.
TEST(Archive, NoticesEveryChangedByte) {
    const std::string bytes = papers::archive_text(example());
    const auto files = example().files;
    int n_noticed = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string changed = bytes;
        changed[at] ^= 1;
        const Kept kept(changed);
        try {
            EXPECT_EQ(papers::read_archive(kept.path).files, files) << "byte " << at;
        } catch (const contact::InputError&) {
            ++n_noticed;
        }
    }
    EXPECT_GT(n_noticed, 100);
}

TEST(Archive, RefusesWhatIsNone) {
    EXPECT_NE(why_refused("no zip file"), "");
    const std::string bytes = papers::archive_text(example());
    EXPECT_NE(why_refused(bytes.substr(0, bytes.size() / 2)), "");
}

}  // namespace
}  // namespace tricontact::archive_test
