#include "io/results/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "contact/base/error.h"
#include "tests/unit/io/temporary_folder.h"

namespace tricontact::io::atomic_file_test {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public TemporaryFolder {
  protected:
    std::string at(const std::string& name) const { return (root_ / name).string(); }
    std::string content(const std::string& name) const { return content_of(at(name)); }
    std::ptrdiff_t n_files() const {
        return std::distance(fs::directory_iterator(root_), fs::directory_iterator());
    }
};

TEST_F(AtomicFile, WritesAndReplacesBytes) {
    const std::string bytes("a\0b\r\n\xff", 6);
    write_file(at("file"), "old and longer than the new content");
    write_file(at("file"), bytes);
    EXPECT_EQ(content("file"), bytes);
    EXPECT_EQ(n_files(), 1);
}

TEST_F(AtomicFile, NewFilesHaveTheUsualPermissions) {
    write_file(at("file"), "x");
    std::ofstream(at("usual")) << "x";
    EXPECT_EQ(fs::status(at("file")).permissions(), fs::status(at("usual")).permissions());
}

TEST_F(AtomicFile, AFailureNamesPathReasonAndRemedyAndLeavesNothing) {
    EXPECT_EQ(
        message_of([&] { write_file(at("no/file"), "x"); }),
        at("no/file") + ": cannot be written (No such file or directory); make the folder first");
    write_file(at("plain"), "x");
    EXPECT_EQ(
        message_of([&] { write_file(at("plain/file"), "x"); }),
        at("plain/file") + ": cannot be written (Not a directory); choose another output folder");
    fs::create_directory(at("folder"));
    EXPECT_EQ(message_of([&] { write_file(at("folder"), "x"); }),
              at("folder") + ": cannot be written (Is a directory); choose another output folder");
    EXPECT_EQ(message_of([&] { write_file(at("folder/"), "x"); }),
              at("folder/") + ": names no file to write; add a file name");
    EXPECT_EQ(n_files(), 2);
}

// A limit on the file size acts like a full disk: some bytes are written, the rest is not.
TEST_F(AtomicFile, AFullDiskKeepsTheOldFile) {
    write_file(at("file"), "old");
    rlimit old_limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, old_limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message = message_of([&] { write_file(at("file"), std::string(5000, 'x')); });
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
    std::signal(SIGXFSZ, old_handler);

    EXPECT_EQ(message, at("file") +
                           ": cannot be written (File too large); free space on the disk, "
                           "or choose another output folder");
    EXPECT_EQ(content("file"), "old");
    EXPECT_EQ(n_files(), 1);
}

TEST_F(AtomicFile, OutputFoldersAreMadeWithTheirParents) {
    make_output_folder(at("a/b/c"));
    EXPECT_TRUE(fs::is_directory(at("a/b/c")));
    EXPECT_TRUE(fs::is_empty(at("a/b/c")));
    make_output_folder(at("a/b/c/"));  // again, and with a slash
    EXPECT_TRUE(fs::is_empty(at("a/b/c")));
}

TEST_F(AtomicFile, OutputFoldersThatCannotBeAreRefused) {
    write_file(at("plain"), "x");
    EXPECT_EQ(message_of([&] { make_output_folder(at("plain")); }),
              at("plain") + ": is a file, not an output folder; name a folder, or remove the file");
    EXPECT_EQ(message_of([&] { make_output_folder(at("plain/folder")); }),
              at("plain/folder") +
                  ": the output folder cannot be made (Not a directory); choose "
                  "another output folder");
    EXPECT_EQ(message_of([] { make_output_folder(""); }),
              "output folder: has no name; name a folder");
}

TEST_F(AtomicFile, OutputFoldersWithoutPermissionAreRefused) {
    fs::create_directory(at("locked"));
    ::chmod(at("locked").c_str(), 0555);
    ::chmod(at("").c_str(), 0755);
    // Root may write everywhere: be nobody for a while.
    const uid_t user = ::geteuid();
    ASSERT_TRUE(user != 0 || ::seteuid(65534) == 0);
    EXPECT_EQ(message_of([&] { make_output_folder(at("locked")); }),
              at("locked") +
                  ": the output folder cannot be written to (Permission denied); choose "
                  "an output folder in which you may write");
    EXPECT_EQ(message_of([&] { write_file(at("locked/file"), "x"); }),
              at("locked/file") +
                  ": cannot be written (Permission denied); choose an output "
                  "folder in which you may write");
    ASSERT_TRUE(user != 0 || ::seteuid(0) == 0);
    ::chmod(at("locked").c_str(), 0700);
}

}  // namespace
}  // namespace tricontact::io::atomic_file_test
