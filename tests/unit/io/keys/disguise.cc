#include "io/keys/disguise.h"

#include <gtest/gtest.h>

#include "io/case/case_reader.h"

namespace tricontact::io::disguise_test {
namespace {

TEST(Disguise, IsUndoneExactly) {
    const std::string text = "a\u00e4b\u00df\u00e4\u201c\u3000\ufb3e\U0001d70f \U0010ffff\u00e4\n";
    Disguise disguise;
    const std::string disguised = disguise.put_on(text);
    EXPECT_EQ(disguised,
              "a\U000f0000b\U000f0001\U000f0000\U000f0002\U000f0003\U000f0004\U000f0005 "
              "\U000f0006\U000f0000\n");
    EXPECT_EQ(disguise.take_off(disguised), text);
}

TEST(Disguise, LeavesAsciiAndAByteOrderMarkInFront) {
    Disguise disguise;
    EXPECT_EQ(disguise.put_on("\ufeff"
                              "a = 1"),
              "\ufeff"
              "a = 1");
    EXPECT_EQ(disguise.take_off("a = 1 \u00e4"), "a = 1 \u00e4");
}

TEST(Disguise, ManyCharactersKeepApart) {
    std::string text;
    for (int high = 0xE1; high <= 0xEC; ++high)  // U+1000 to U+CFFF
        for (int middle = 0x80; middle <= 0xBF; ++middle)
            for (int low = 0x80; low <= 0xBF; ++low)
                text +=
                    {static_cast<char>(high), static_cast<char>(middle), static_cast<char>(low)};
    Disguise disguise;
    EXPECT_EQ(disguise.take_off(disguise.put_on(text)), text);
}

TEST(Disguise, DoesNotShowInACase) {
    const auto c = read_case(TRICONTACT_SOURCE_DIR "/examples/cases/rig_sphere_parallel.toml",
                             {"title=\"\u00dcbung \u201c1\u201d\"", "rolling.angle=\"5 \u00b0\""});
    EXPECT_EQ(c.title, "\u00dcbung \u201c1\u201d");
    EXPECT_GT(c.rolling->angle, 0);
}

}  // namespace
}  // namespace tricontact::io::disguise_test
