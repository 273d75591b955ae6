#include <gtest/gtest.h>

#include "io/case_reader.h"
#include "io/stray_character.h"

namespace tricontact::io {
namespace {

constexpr auto none = std::string_view::npos;

TEST(StrayCharacter, MayStandInStringsAndComments) {
    EXPECT_EQ(stray_character("a = 1"), none);
    EXPECT_EQ(stray_character("# \u00e4\na = 1"), none);
    EXPECT_EQ(stray_character("a = \"\u00e4\" # \u00e4"), none);
    EXPECT_EQ(stray_character("a = '\u00e4'"), none);
    EXPECT_EQ(stray_character("a = '''\n\u00e4'\n'''"), none);
    EXPECT_EQ(stray_character("a = \"\"\"\n\u00e4\"\n\\\"\"\"\u00e4\"\"\""), none);
    EXPECT_EQ(stray_character("\xEF\xBB\xBF"
                              "a = 1"),
              none);
}

TEST(StrayCharacter, IsFoundElsewhere) {
    EXPECT_EQ(stray_character("\u00e4 = 1"), 0U);
    EXPECT_EQ(stray_character("# c\n\u00e4 = 1"), 4U);
    EXPECT_EQ(stray_character("a = \"\"\u00e4"), 6U);
    EXPECT_EQ(stray_character("a = '\\'\u00e4"), 7U);      // no escapes in literal strings
    EXPECT_EQ(stray_character("a = \"\\\"\"\u00e4"), 8U);  // but in basic ones
    EXPECT_EQ(stray_character("a = \"\"\"x\"\"\"\"\"\u00e4"), 13U);  // two quotes end the text
}

TEST(StrayCharacter, AQuoteGluedToAWordBeginsNoString) {
    EXPECT_EQ(stray_character("a = 1\"\u00e4\""), 6U);
    EXPECT_EQ(stray_character("a\"\u00e4\" = 1"), 2U);
    EXPECT_EQ(stray_character("\"a\".\"\u00e4\" = [\"\u00e4\",\"\u00e4\"]"), none);
}

TEST(StrayCharacter, MayNotFollowABackslashInAStringOfSeveralLines) {
    EXPECT_EQ(stray_character("a = \"\"\"x\\\u00e4\"\"\""), 9U);
    EXPECT_EQ(stray_character("a = \"\"\"x\\ \n \u00e4\"\"\""), 12U);
    EXPECT_EQ(stray_character("a = \"\"\"x\\n\u00e4\"\"\""), none);
    EXPECT_EQ(stray_character("a = '''x\\\u00e4'''"), none);
}

TEST(StrayCharacter, ReadingEndsWithAnUnclosedString) {
    EXPECT_EQ(stray_character("a = \"x\n\u00e4"), none);
    EXPECT_EQ(stray_character("a = \"\"\"x\n\u00e4"), none);
    EXPECT_EQ(stray_character("a = \"\\"), none);
}

TEST(StrayCharacter, InAnOverrideMakesABareText) {
    const auto c = read_case(TRICONTACT_SOURCE_DIR "/cases/rig_sphere_parallel.toml",
                             {"title=\u00dcbung", "rolling.angle=5 \u00b0"});
    EXPECT_EQ(c.title, "\u00dcbung");
    EXPECT_GT(c.rolling->angle, 0);
}

}  // namespace
}  // namespace tricontact::io
