#include "io/results/zip_file.h"

#include <gtest/gtest.h>
#include <zip.h>

#include "tests/unit/io/temporary_folder.h"

namespace tricontact::io::zip_file_test {
namespace {

class ZipFile : public TemporaryFolder {
  protected:
    std::string at(const std::string& name) const { return (root_ / name).string(); }

    void put(const std::string& bytes) const {
        std::ofstream(at("a.zip"), std::ios::binary) << bytes;
    }
    /// What is said of an archive of these bytes.
    std::string refusal_of(const std::string& bytes) const {
        put(bytes);
        return message_of([&] { read_zip(at("a.zip")); });
    }
    /// An archive made by libzip without this project's writer. `mode`: of Unix.
    std::string foreign(const std::string& name, zip_uint32_t mode) const {
        zip_t* archive = zip_open(at("b.zip").c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
        const auto index = zip_file_add(archive, name.c_str(),
                                        zip_source_buffer(archive, "x", 1, 0), ZIP_FL_ENC_UTF_8);
        zip_file_set_external_attributes(archive, static_cast<zip_uint64_t>(index), 0,
                                         ZIP_OPSYS_UNIX, mode << 16);
        zip_close(archive);
        return content_of(at("b.zip"));
    }
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(ZipFile, ReadsWhatItWrote) {
    const ZipFiles files{
        {"a.txt", "first"}, {"empty", ""}, {"ä/b.bin", std::string("\0\xff\n", 3)}};
    put(zip_of(files));
    EXPECT_EQ(read_zip(at("a.zip")), files);
    EXPECT_EQ(zip_of(files), zip_of(files));
}

TEST_F(ZipFile, OthersReadItToo) {
    put(zip_of({{"a/b.txt", std::string(100'000, 'x')}}));
    zip_t* archive = zip_open(at("a.zip").c_str(), ZIP_RDONLY | ZIP_CHECKCONS, nullptr);
    ASSERT_TRUE(archive);
    zip_stat_t status;
    ASSERT_EQ(zip_stat(archive, "a/b.txt", 0, &status), 0);
    EXPECT_EQ(status.size, 100'000U);
    EXPECT_LT(status.comp_size, 1000U);
    zip_discard(archive);
}

TEST_F(ZipFile, RefusesWhatIsNoArchive) {
    EXPECT_TRUE(contains(refusal_of("no archive"), "a.zip: is no zip archive, or only a part"));
    const std::string whole = zip_of({{"a.txt", std::string(1000, 'a')}});
    EXPECT_TRUE(contains(refusal_of(whole.substr(0, whole.size() / 2)), "is no zip archive"));
    EXPECT_TRUE(contains(message_of([&] { read_zip(at("none.zip")); }), "cannot be read"));
    EXPECT_TRUE(contains(message_of([&] { read_zip(root_.string()); }), "is a directory"));
}

TEST_F(ZipFile, RefusesDamage) {
    std::string bytes = zip_of({{"a.txt", "0123456789 and so on"}});
    const auto at = bytes.find("a.txt") + 5;  // of the compressed content
    bytes[at + 6] = static_cast<char>(bytes[at + 6] ^ 1);
    EXPECT_TRUE(contains(refusal_of(bytes), "a.txt, which is damaged"));
}

TEST_F(ZipFile, RefusesNamesThatLeadOut) {
    constexpr zip_uint32_t regular = 0100644, link = 0120777;
    for (const char* name : {"/etc/passwd", "../a", "a/../../b", "a\\b", "./a"})
        EXPECT_TRUE(contains(refusal_of(foreign(name, regular)), "no name within an archive"))
            << name;
    EXPECT_TRUE(contains(refusal_of(foreign("a", link)), "a link or no regular file"));
    EXPECT_EQ(refusal_of(foreign("a/b", regular)), "(no error)");
    EXPECT_EQ(refusal_of(foreign("a/b", 0)), "(no error)");
}

// Zeros pack two hundred times smaller, even quickly: they are read up to the bound and no further.
TEST_F(ZipFile, RefusesMoreThanItHolds) {
    const std::string zeros(100'000'000, '\0');
    const auto add = [](zip_t* archive, const char* name, zip_source_t* source) {
        const auto index = static_cast<zip_uint64_t>(zip_file_add(archive, name, source, 0));
        zip_set_file_compression(archive, index, ZIP_CM_DEFLATE, 1);  // quickly
    };
    zip_t* one = zip_open(at("one.zip").c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    add(one, "1", zip_source_buffer(one, zeros.data(), zeros.size(), 0));
    zip_close(one);
    // Packed once, copied as it is packed.
    one = zip_open(at("one.zip").c_str(), ZIP_RDONLY, nullptr);
    zip_t* archive = zip_open(at("b.zip").c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    for (const char* name : {"1", "2", "3", "4", "5", "6"})
        add(archive, name, zip_source_zip(archive, one, 0, ZIP_FL_COMPRESSED, 0, -1));
    zip_close(archive);
    zip_close(one);
    const std::string bomb = content_of(at("b.zip"));
    EXPECT_LT(bomb.size(), 3'000'000U);
    EXPECT_TRUE(contains(refusal_of(bomb), "holds more than 500 MB"));
    ZipFiles many;
    for (int i = 0; i <= 10'000; ++i) many[std::to_string(i)];
    EXPECT_TRUE(contains(message_of([&] { zip_of(many); }), "more than 10000 files or 500 MB"));
}

}  // namespace
}  // namespace tricontact::io::zip_file_test
