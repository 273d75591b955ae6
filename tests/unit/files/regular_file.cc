// Reading never waits, whatever a name leads to.

#include "files/regular_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "files/digest.h"

namespace tricontact::files::regular_file_test {
namespace {

namespace fs = std::filesystem;

class Regular : public testing::Test {
  protected:
    Regular() {
        std::string name = (fs::temp_directory_path() / "tricontact-files-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    ~Regular() override { fs::remove_all(folder_); }

    std::string at(const std::string& name) const { return folder_ + '/' + name; }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(at(name), std::ios::binary) << bytes;
        return at(name);
    }
    static std::string why(const std::string& path) {
        try {
            RegularFile(path).content(1'000'000);
        } catch (const Unreadable& error) {
            return error.what();
        }
        return "(read)";
    }

    std::string folder_;
};

TEST_F(Regular, GivesAllBytes) {
    const std::string bytes("a\0b\r\n\xff", 6);
    EXPECT_EQ(RegularFile(write("a", bytes)).content(6), bytes);
    EXPECT_EQ(RegularFile(write("empty", "")).content(0), "");
    const std::string large(200'000, 'x');
    EXPECT_EQ(RegularFile(write("large", large)).content(1'000'000), large);
    fs::create_symlink(at("a"), at("link"));
    EXPECT_EQ(RegularFile(at("link")).content(6), bytes);
}

TEST_F(Regular, SaysWhatIsWrong) {
    EXPECT_EQ(why(at("missing")), "cannot be read (No such file or directory)");
    EXPECT_EQ(why(folder_), "is a directory");
    EXPECT_EQ(why(write("long", std::string(1'000'001, 'x'))), "is larger than 1 MB");
    fs::create_symlink(at("loop"), at("loop"));
    EXPECT_EQ(why(at("loop")), "cannot be read (Too many levels of symbolic links)");
}

TEST_F(Regular, NeverWaits) {
    ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
    EXPECT_EQ(why(at("pipe")), "is not a regular file");
    fs::create_symlink(at("pipe"), at("link"));
    EXPECT_EQ(why(at("link")), "is not a regular file");
    EXPECT_EQ(why("/dev/zero"), "is not a regular file");
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{AF_UNIX, {}};
    at("socket").copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(why(at("socket")), "is not a regular file");
    ::close(socket);
    EXPECT_NE(why("/proc/kmsg"), "(read)");  // regular by its kind, and waits for the kernel
}

TEST_F(Regular, GivesLines) {
    const auto lines_of = [&](const std::string& bytes) {
        LineReader reader(write("lines", bytes));
        std::vector<std::string> lines;
        for (std::string line; reader.next(line);) lines.push_back(line);
        return lines;
    };
    using Lines = std::vector<std::string>;
    EXPECT_EQ(lines_of(""), Lines{});
    EXPECT_EQ(lines_of("a"), Lines{"a"});
    EXPECT_EQ(lines_of("a\n"), Lines{"a"});
    EXPECT_EQ(lines_of("\na\n\nb"), (Lines{"", "a", "", "b"}));
    // Ends on both sides of the end of a buffer, and in it.
    for (const std::size_t n : {65534u, 65535u, 65536u, 65537u, 200'000u})
        EXPECT_EQ(lines_of(std::string(n, 'x') + "\nend\n"), (Lines{std::string(n, 'x'), "end"}))
            << n;
    EXPECT_THROW(lines_of(std::string(1'100'000, 'x')), Unreadable);
}

// Values of the XXH3 algorithm by its authors: the empty input, and "a" as xxhsum -H2 prints it.
TEST(Digest, IsThatOfXxh3) {
    EXPECT_EQ(digest_of(""), "99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(digest_of("a"), "a96faf705af16834e6c632b61e964e1f");
}

TEST(Digest, KeepsTextsApart) {
    const auto of = [](std::string_view a, std::string_view b) {
        Digest digest;
        digest << a << b;
        return digest.text();
    };
    EXPECT_EQ(of("ab", "c"), of("ab", "c"));
    EXPECT_NE(of("ab", "c"), of("a", "bc"));
    EXPECT_NE(of("", "c"), of("c", ""));
}

}  // namespace
}  // namespace tricontact::files::regular_file_test
