#include <gtest/gtest.h>

#include "io/case/case_reader.h"
#include "io/keys/toml_text.h"
#include "tests/paths.h"

namespace tricontact::io::non_ascii_escaper_test {
namespace {

TEST(NonAsciiEscaper, IsUndoneExactly) {
    const std::string text =
        "a\u00e4b\u0080\u201c\ufb3e\ufeff\uff01\U0001d70f \U000f00e4\U0010ffff\n";
    const std::string escaped = escape_non_ascii(text);
    EXPECT_EQ(escaped,
              "a\U000400e4b\U00040080\U0004201c\U0004fb3e\U0004feff\uff01\U0001d70f "
              "\U000f00e4\U0010ffff\n");
    EXPECT_EQ(restore_non_ascii(escaped), text);
}

TEST(NonAsciiEscaper, LeavesAsciiAndAByteOrderMarkInFront) {
    EXPECT_EQ(escape_non_ascii("\ufeff"
                               "a = 1"),
              "\ufeff"
              "a = 1");
    EXPECT_EQ(restore_non_ascii("a = 1 \u00e4"), "a = 1 \u00e4");
    EXPECT_EQ(restore_non_ascii("cut \xe4"), "cut \xe4");
}

TEST(NonAsciiEscaper, ManyCharactersKeepApart) {
    std::string text;
    for (int high = 0xE1; high <= 0xEC; ++high)  // U+1000 to U+CFFF
        for (int middle = 0x80; middle <= 0xBF; ++middle)
            for (int low = 0x80; low <= 0xBF; ++low)
                text +=
                    {static_cast<char>(high), static_cast<char>(middle), static_cast<char>(low)};
    EXPECT_EQ(restore_non_ascii(escape_non_ascii(text)), text);
}

TEST(NonAsciiEscaper, DoesNotShowInACase) {
    const auto c = read_case(paths::source("examples/cases/rig_sphere_parallel.toml"),
                             {"title=\"\u00dcbung \u201c1\u201d\"", "rolling.angle=\"5 \u00b0\""});
    EXPECT_EQ(c.title, "\u00dcbung \u201c1\u201d");
    EXPECT_GT(c.rolling->angle, 0);
}

}  // namespace
}  // namespace tricontact::io::non_ascii_escaper_test
