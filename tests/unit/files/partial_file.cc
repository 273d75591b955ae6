// What a killed process leaves goes, what a living one writes stays.

#include "files/partial_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace tricontact::files::partial_file_test {
namespace {

namespace fs = std::filesystem;

class Partial : public testing::Test {
  protected:
    Partial() {
        std::string name = (fs::temp_directory_path() / "tricontact-partial-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~Partial() override { fs::remove_all(folder_); }

    std::string at(const std::string& name) const { return folder_ + '/' + name; }
    std::string content(const std::string& name) const {
        std::ostringstream out;
        out << std::ifstream(at(name), std::ios::binary).rdbuf();
        return out.str();
    }
    std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_))
            found.insert(entry.path().filename().string());
        return found;
    }
    void leave(const std::string& name) const {
        const pid_t child = ::fork();
        if (child == 0) {
            PartialFile file(at(name));
            file.write("half");
            ::raise(SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
    }

    std::string folder_;
};

using Names = std::set<std::string>;

TEST_F(Partial, MovesOrGoes) {
    {
        PartialFile file(at("a"));
        file.write("one ");
        file.write("two");
        EXPECT_EQ(names(), Names{".a.partial-0"});
        file.move_to_target();
        EXPECT_EQ(names(), Names{"a"});
        const PartialFile other(at("b"), ".msh");
        EXPECT_EQ(other.path(), at(".b.partial-0.msh"));
    }
    EXPECT_EQ(names(), Names{"a"});
    EXPECT_EQ(content("a"), "one two");
}

TEST_F(Partial, WritersOfOneTargetDoNotMeet) {
    PartialFile first(at("a")), second(at("a"));
    first.write("first");
    second.write("second");
    second.move_to_target();
    first.move_to_target();
    EXPECT_EQ(content("a"), "first");
    EXPECT_EQ(names(), Names{"a"});
}

TEST_F(Partial, TheNextWriterRemovesWhatAKilledOneLeft) {
    leave("a");
    ASSERT_EQ(names(), Names{".a.partial-0"});
    PartialFile(at("a")).move_to_target();
    EXPECT_EQ(names(), Names{"a"});
    EXPECT_EQ(content("a"), "");
}

TEST_F(Partial, SweepsWhatIsLeftAndNothingElse) {
    leave("a");
    leave("b");
    const Names others{"a",           ".b",          ".partial-1", ".c.partial-", ".c.partial-x",
                       "c.partial-0", ".d.partial-0"};
    for (const std::string& name : others) std::ofstream(at(name)) << "mine";
    fs::remove(at(".d.partial-0"));
    fs::create_symlink(at("a"), at(".d.partial-0"));
    PartialFile living(at("e"));
    remove_left_partial_files(folder_);
    Names due = others;
    due.insert(".e.partial-0");
    EXPECT_EQ(names(), due);
    living.write("whole");
    living.move_to_target();
    EXPECT_EQ(content("e"), "whole");
    remove_left_partial_files(at("missing"));
}

// A sweeper beside writers: each write arrives whole.
TEST_F(Partial, SweepingBesideWritersLosesNothing) {
    const pid_t sweeper = ::fork();
    if (sweeper == 0)
        while (true) remove_left_partial_files(folder_);
    for (int i = 0; i < 20; ++i) {
        PartialFile file(at("a"));
        file.write(std::to_string(i));
        ASSERT_NO_THROW(file.move_to_target()) << i;
        ASSERT_EQ(content("a"), std::to_string(i));
    }
    ::kill(sweeper, SIGKILL);
    ::waitpid(sweeper, nullptr, 0);
    EXPECT_EQ(names(), Names{"a"});
}

// The second of two that write a target waits for the first: until it is done, or was killed.
TEST_F(Partial, TheSecondWriterWaitsForTheFirst) {
    for (const bool killed : {false, true}) {
        std::array<int, 2> ends{};
        ASSERT_EQ(::pipe(ends.data()), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            PartialFile file(at("target"));
            write_all(ends[1], file.is_first() ? "1" : "0");
            ::usleep(50'000);
            if (killed) ::raise(SIGKILL);
            file.write("first");
            file.move_to_target();
            ::_exit(0);
        }
        char first = 0;
        ASSERT_EQ(::read(ends[0], &first, 1), 1);
        EXPECT_EQ(first, '1');
        EXPECT_FALSE(PartialFile(at("target")).is_first());
        EXPECT_TRUE(wait_for_first_writer(at("target")));
        EXPECT_EQ(content("target"), killed ? "" : "first");
        EXPECT_TRUE(PartialFile(at("target")).is_first());
        EXPECT_TRUE(wait_for_first_writer(at("target")));  // nobody is there
        int status = 0;
        ::waitpid(child, &status, 0);
        for (const int end : ends) ::close(end);
        fs::remove(at("target"));
    }
    EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace tricontact::files::partial_file_test
