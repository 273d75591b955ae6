#include "io/keys/messages.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "contact/base/error.h"

namespace tricontact::io::messages_test {
namespace {

TEST(Messages, TomlStringsEscapeWhatTomlForbids) {
    EXPECT_EQ(toml_string("a \"b\" \\ \n\t\x01\x7f \u00e4"),
              R"("a \"b\" \\ \n\t\u0001\u007F )" + std::string("\u00e4\""));
}

TEST(Messages, NumbersReadBackTheSameAndAreTomlFloats) {
    EXPECT_EQ(toml_number(22), "22.0");
    EXPECT_EQ(toml_number(-0.), "-0.0");
    EXPECT_EQ(toml_number(1e-7), "1e-07");
    EXPECT_EQ(toml_number(1e23), "1e+23");
    EXPECT_EQ(toml_number(0.1), "0.1");
    EXPECT_EQ(std::stod(shortest(0.1 + 0.2)), 0.1 + 0.2);
    EXPECT_EQ(shortest(std::numeric_limits<double>::denorm_min()), "5e-324");
}

TEST(Messages, ShorteningKeepsCharactersWhole) {
    EXPECT_EQ(shortened("abc", 3), "abc");
    EXPECT_EQ(shortened("abcd", 3), "abc...");
    EXPECT_EQ(shortened("ab\u20ac", 4), "ab...");  // the euro sign has three bytes
}

TEST(Messages, Utf8IsToldFromOtherBytes) {
    for (const char* text : {"", "abc", "\u00e4\u20ac\U0001d70f", "\U0010ffff"})
        EXPECT_EQ(first_non_utf8(text), std::string::npos) << text;
    for (const char* text : {"\xe4", "\xc3", "\xe2\x82", "\x80", "\xff", "\xc0\x80", "\xe0\x80\x80",
                             "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf0\x82\x82\xac"})
        EXPECT_EQ(first_non_utf8("\u00e4" + std::string(text)), 2U) << text;
}

TEST(Messages, NearestForgivesTypingErrorsOnly) {
    constexpr std::array<std::string_view, 3> names{"radius", "young", "poisson"};
    EXPECT_EQ(nearest("raduis", names), "radius");
    EXPECT_EQ(nearest("Young", names), "young");
    EXPECT_EQ(nearest("poison", names), "poisson");
    EXPECT_EQ(nearest("thickness", names), "");
    EXPECT_EQ(nearest(std::string(1000, 'r'), names), "");
}

TEST(Messages, FailIsOneLineOfPlaceSubjectRuleRemedy) {
    try {
        fail("a.toml:1:2", "key = 3", "rule\nin two lines", "remedy");
        FAIL();
    } catch (const contact::InputError& error) {
        EXPECT_STREQ(error.what(), "a.toml:1:2: key = 3: rule in two lines; remedy");
    }
}

}  // namespace
}  // namespace tricontact::io::messages_test
