// Nothing is replaced that this program did not write, and nothing is left of a call that is
// refused.

#include "io/results/output_folder.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "contact/base/error.h"
#include "io/keys/input_file.h"
#include "io/results/atomic_file.h"
#include "io/results/result_store.h"
#include "tests/unit/io/temporary_folder.h"

namespace tricontact::io::output_folder_test {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        out_ = (root_ / "out").string();
    }

    static void put(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
    }
    static std::string content(const fs::path& path) { return content_of(path); }
    // Everything below the root: kinds, and the content of regular files.
    std::map<std::string, std::string> everything() const {
        std::map<std::string, std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(root_)) {
            const auto type = entry.symlink_status().type();
            found[entry.path().string()] = std::to_string(static_cast<int>(type)) +
                                           (type == fs::file_type::regular ? content(entry) : "");
        }
        return found;
    }
    // A call that writes what it names.
    void call(const std::string& text = "new") const {
        OutputFolder folder(out_, names());
        folder.fill([&] {
            for (const char* name : {"a.csv", "model/history.csv", "model/state_1", "plots/p"}) {
                make_output_folder(fs::path(out_ + '/' + name).parent_path());
                write_file(out_ + '/' + name, text);
            }
        });
    }
    static OutputNames names() { return {{"a.csv", "model/history.csv"}, {"plots/"}}; }

    // Refused with this text, before and in the call, and nothing has changed.
    void expect_refused(const std::string& text) const {
        const auto before = everything();
        EXPECT_NE(message_of([&] { OutputFolder(out_, names()); }).find(text), std::string::npos)
            << message_of([&] { OutputFolder(out_, names()); });
        EXPECT_NE(message_of([&] { call(); }).find(text), std::string::npos);
        EXPECT_EQ(everything(), before);
    }

    std::string out_;
};

TEST_F(OutputFolderTest, IsFilledAgainAndAgain) {
    call("first");
    call("second");
    EXPECT_EQ(content(out_ + "/a.csv"), "second");
    EXPECT_EQ(content(out_ + "/.tricontact"),
              "# Files and folders here that tricontact wrote and may replace; it leaves others "
              "alone.\na.csv\nmodel/\nplots/\n");
}

TEST_F(OutputFolderTest, IsFilledByOneAtATime) {
    OutputFolder(out_, names()).fill([&] {
        write_file(out_ + "/a.csv", "first");
        const auto before = everything();
        EXPECT_EQ(message_of([&] { call("second"); }),
                  out_ +
                      ": is being filled by another run; wait until that has ended, or choose "
                      "another output folder");
        EXPECT_EQ(everything(), before);
        OutputFolder(out_ + "/plots", names()).fill([] {});  // is another folder
    });
    EXPECT_EQ(content(out_ + "/a.csv"), "first");
    call("third");
    EXPECT_EQ(content(out_ + "/a.csv"), "third");
    EXPECT_THROW(OutputFolder(out_, names()).fill([] { throw std::runtime_error("failed"); }),
                 std::runtime_error);
    call("fourth");
}

TEST_F(OutputFolderTest, RemovesResultsOfEarlierCallsAtTheStart) {
    call();
    OutputFolder folder(out_, names());
    EXPECT_TRUE(fs::exists(out_ + "/a.csv")) << "not before the start";
    EXPECT_THROW(folder.fill([] { throw std::runtime_error("failed"); }), std::runtime_error);
    EXPECT_FALSE(fs::exists(out_ + "/a.csv"));
    EXPECT_FALSE(fs::exists(out_ + "/model/history.csv"));
    EXPECT_TRUE(fs::exists(out_ + "/plots/p"));
}

TEST_F(OutputFolderTest, LeavesOtherFilesOfTheFolderAlone) {
    put(out_ + "/notes.txt", "mine");
    put(out_ + "/raw/record.csv", "mine");
    fs::create_symlink("notes.txt", out_ + "/link");
    call();
    EXPECT_EQ(content(out_ + "/notes.txt"), "mine");
    EXPECT_EQ(content(out_ + "/raw/record.csv"), "mine");
    EXPECT_TRUE(fs::is_symlink(out_ + "/link"));
}

TEST_F(OutputFolderTest, RefusesFilesThatItDidNotWrite) {
    put(out_ + "/a.csv", "mine");
    expect_refused(out_ + "/a.csv: is there already, and tricontact did not write it; remove it");
    fs::remove(out_ + "/a.csv");
    put(out_ + "/plots/mine.svg", "mine");
    expect_refused(out_ + "/plots: is there already, and tricontact did not make it");
    fs::remove_all(out_ + "/plots");
    put(out_ + "/model", "a file");
    expect_refused("/model: is a file where a folder is to be made");
    fs::remove(out_ + "/model");
    fs::create_directory(out_ + "/model");  // empty: anybody's
    call();
}

TEST_F(OutputFolderTest, RefusesLinksDevicesPipesAndSockets) {
    put(root_ / "target", "precious");
    put(root_ / "elsewhere/history.csv", "precious");
    const auto refused_at = [&](const std::string& name, const auto& make) {
        call();
        const std::string path = out_ + '/' + name;
        fs::remove_all(path);
        make(path);
        expect_refused(path + ": is a");
        fs::remove_all(out_);
    };
    const auto link = [&](const std::string& path) { fs::create_symlink(root_ / "target", path); };
    const auto pipe = [](const std::string& path) { ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0); };
    for (const char* name : {"a.csv", "model/history.csv", "model/state_1", "plots/p", "plots"}) {
        refused_at(name, link);
        refused_at(name, pipe);
        refused_at(name, [](const std::string& path) { fs::create_symlink("nowhere", path); });
        refused_at(name, [](const std::string& path) {
            sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
            const fs::path here = fs::current_path();
            fs::current_path(fs::path(path).parent_path());  // names of sockets are short
            fs::path(path).filename().string().copy(address.sun_path, sizeof address.sun_path - 1);
            const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
            ASSERT_EQ(::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
            ::close(fd);
            fs::current_path(here);
        });
    }
    refused_at("model", [&](const std::string& path) {
        fs::create_directory_symlink(root_ / "elsewhere", path);
    });
    refused_at(".tricontact", link);
    refused_at(".tricontact", pipe);
    EXPECT_EQ(content(root_ / "target"), "precious");
    EXPECT_EQ(content(root_ / "elsewhere/history.csv"), "precious");
}

TEST_F(OutputFolderTest, RefusesInputsByWhateverPath) {
    call();
    fs::create_directory_symlink(out_, root_ / "way");
    EXPECT_EQ(read_input_file((root_ / "way/a.csv").string()), "new");
    expect_refused(out_ + "/a.csv: is an input of this command, which it would replace");
    EXPECT_NE(message_of([&] {
                  write_file((root_ / "way/../way/a.csv").string(), "x");
              }).find("is an input"),
              std::string::npos);
}

TEST_F(OutputFolderTest, TheFolderItselfMayBeALink) {
    fs::create_directory(root_ / "disk");
    fs::create_directory_symlink(root_ / "disk", out_);
    call();
    EXPECT_EQ(content(root_ / "disk/a.csv"), "new");
    EXPECT_TRUE(fs::is_symlink(out_));
    fs::remove_all(root_ / "disk");
    expect_refused("is a link that leads nowhere");
}

TEST_F(OutputFolderTest, RefusesAListThatIsNone) {
    put(out_ + "/.tricontact", "a.csv\n");
    put(out_ + "/a.csv", "mine");
    expect_refused("/.tricontact: is no list of output files");
}

TEST_F(OutputFolderTest, AStoreOfResultsTellsWhoseItIs) {
    fs::create_directories(out_);
    const auto fill = [&] { OutputFolder(out_, {{}, result_store_files()}).fill([] {}); };
    { const ResultStore store(out_ + '/' + result_store_name); }
    EXPECT_TRUE(is_result_store(out_ + '/' + result_store_name));
    EXPECT_EQ(message_of(fill), "(no error)");
    fs::remove(out_ + "/.tricontact");
    std::string bytes = content(out_ + '/' + result_store_name);
    bytes[71] ^= 1;
    put(out_ + '/' + result_store_name, bytes);
    EXPECT_FALSE(is_result_store(out_ + '/' + result_store_name));
    EXPECT_NE(message_of(fill).find("tricontact did not write it"), std::string::npos);
}

TEST_F(OutputFolderTest, NothingIsLeftOfWorkThatIsRefused) {
    const auto refuse_after = [&](const std::string& out, const auto& work) {
        EXPECT_EQ(message_of([&] {
                      OutputFolder(out, names()).fill([&] {
                          work();
                          throw contact::InputError("no");
                      });
                  }),
                  "no");
    };
    const auto before = everything();
    refuse_after(out_ + "/deep/er", [&] {
        write_file(out_ + "/deep/er/a.csv", "x");
        make_output_folder(out_ + "/deep/er/model");
    });
    EXPECT_EQ(everything(), before);
    // What others put there meanwhile stays.
    refuse_after(out_, [&] { put(out_ + "/notes", "mine"); });
    EXPECT_EQ(content(out_ + "/notes"), "mine");
    EXPECT_FALSE(fs::exists(out_ + "/.tricontact"));
    // Results are no refusal's to take: the disk was full after hours.
    refuse_after(out_, [&] { put(out_ + "/model/steps.journal", "tricontact journal 1\n"); });
    EXPECT_TRUE(fs::exists(out_ + "/model/steps.journal"));
    call();
    refuse_after(out_, [] {});
    EXPECT_EQ(content(out_ + "/plots/p"), "new");
    call();
}

TEST_F(OutputFolderTest, FoldersThatCannotBeAreRefusedWithoutATrace) {
    put(root_ / "plain", "x");
    out_ = (root_ / "plain").string();
    expect_refused("plain: is a file, not an output folder");
    out_ = (root_ / "plain/deeper").string();
    expect_refused("the output folder cannot be made (Not a directory)");
    out_ = "";
    EXPECT_EQ(message_of([&] { OutputFolder("", names()); }),
              "output folder: has no name; name a folder");
}

// Between the look and the start somebody puts a file there.
TEST_F(OutputFolderTest, LooksOnceMoreAtTheStart) {
    call();
    OutputFolder folder(out_, names());
    put(root_ / "target", "precious");
    fs::remove(out_ + "/a.csv");
    fs::create_symlink(root_ / "target", out_ + "/a.csv");
    const auto before = everything();
    EXPECT_NE(message_of([&] { folder.fill([] {}); }).find("is a link"), std::string::npos);
    EXPECT_EQ(everything(), before);
}

TEST_F(OutputFolderTest, NamesWithLineEndsAreOneLineOfTheList) {
    const OutputNames names{{"a\nb.inp"}};
    OutputFolder(out_, names).fill([&] { write_file(out_ + "/a\nb.inp", "x"); });
    OutputFolder(out_, names).fill([] {});
    put(out_ + "/b.inp", "mine");
    EXPECT_NE(message_of([&] { OutputFolder(out_, {{"b.inp"}}); }).find("did not write it"),
              std::string::npos);
}

class OutputFile : public OutputFolderTest {};

TEST_F(OutputFile, IsReplacedOnlyIfItBeginsAsOnesOwn) {
    const std::string path = (root_ / "file").string();
    const auto check = [&] { return message_of([&] { check_output_file(path, "title 1\n"); }); };
    EXPECT_EQ(check(), "(no error)");
    put(path, "title 1\nold");
    EXPECT_EQ(check(), "(no error)");
    put(path, "");
    EXPECT_EQ(check(), "(no error)");
    for (const char* text : {"title 2\n", "title", "precious", "\n"}) {
        put(path, text);
        EXPECT_EQ(check(), path +
                               ": is there already, and tricontact did not write it; remove it, or "
                               "choose another name");
    }
    fs::remove(path);
    fs::create_symlink("nowhere", path);
    EXPECT_NE(check().find("is a link"), std::string::npos);
    EXPECT_NE(message_of([&] { write_file(path, "x"); }).find("is a link"), std::string::npos);
    EXPECT_NE(message_of([&] {
                  check_output_file((root_ / "no/file").string(), "");
              }).find("cannot be written (No such file or directory); make the folder first"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  check_output_file((root_ / "").string(), "");
              }).find("names no file to write"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::output_folder_test
