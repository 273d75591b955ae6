#include <gtest/gtest.h>

#include "io/case/case_reader.h"
#include "io/keys/toml_text.h"

namespace tricontact::io::non_ascii_escaper_test {
namespace {

TEST(NonAsciiEscaper, IsUndoneExactly) {
    const std::string text = "a\u00e4b\u00df\u00e4\u201c\u3000\ufb3e\U0001d70f \U0010ffff\u00e4\n";
    NonAsciiEscaper escaper;
    const std::string escaped = escaper.escaped(text);
    EXPECT_EQ(escaped,
              "a\U000f0000b\U000f0001\U000f0000\U000f0002\U000f0003\U000f0004\U000f0005 "
              "\U000f0006\U000f0000\n");
    EXPECT_EQ(escaper.restored(escaped), text);
}

TEST(NonAsciiEscaper, LeavesAsciiAndAByteOrderMarkInFront) {
    NonAsciiEscaper escaper;
    EXPECT_EQ(escaper.escaped("\ufeff"
                              "a = 1"),
              "\ufeff"
              "a = 1");
    EXPECT_EQ(escaper.restored("a = 1 \u00e4"), "a = 1 \u00e4");
}

TEST(NonAsciiEscaper, ManyCharactersKeepApart) {
    std::string text;
    for (int high = 0xE1; high <= 0xEC; ++high)  // U+1000 to U+CFFF
        for (int middle = 0x80; middle <= 0xBF; ++middle)
            for (int low = 0x80; low <= 0xBF; ++low)
                text +=
                    {static_cast<char>(high), static_cast<char>(middle), static_cast<char>(low)};
    NonAsciiEscaper escaper;
    EXPECT_EQ(escaper.restored(escaper.escaped(text)), text);
}

TEST(NonAsciiEscaper, DoesNotShowInACase) {
    const auto c = read_case(TRICONTACT_SOURCE_DIR "/examples/cases/rig_sphere_parallel.toml",
                             {"title=\"\u00dcbung \u201c1\u201d\"", "rolling.angle=\"5 \u00b0\""});
    EXPECT_EQ(c.title, "\u00dcbung \u201c1\u201d");
    EXPECT_GT(c.rolling->angle, 0);
}

}  // namespace
}  // namespace tricontact::io::non_ascii_escaper_test
