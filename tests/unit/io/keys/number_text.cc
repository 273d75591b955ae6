// Numbers that no double holds are no zeros.

#include "io/keys/number_text.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "io/keys/toml_document.h"

namespace tricontact::io::number_text_test {
namespace {

TEST(NumberText, SourcesThatUnderflow) {
    for (const char* source : {"1e-999999999", "+1e-400", "-3.2E-500 # small", "1_0e-400",
                               "[1, 2e-400]", "[ # 1\n 0.5,\n 1e-999]"})
        EXPECT_TRUE(underflows(source)) << source;
    EXPECT_TRUE(underflows("0." + std::string(400, '0') + "1"));
    for (const char* source :
         {"0", "0.0", "-0e-999", "+0", "1e-300", "5e-324", "0x0", "0 # 1e-999", "[0, 1]", "[]",
          "[0, # 1e-999\n 2]", "", "+", "-", "nan", "inf", "\"1e-999\"", "0.0e+400"})
        EXPECT_FALSE(underflows(source)) << source;
}

TEST(NumberText, ScaledNumbersStayNumbers) {
    EXPECT_EQ(scaled(3, 0.5, "a:1"), 1.5);
    EXPECT_EQ(scaled(0, 1e-9, "a:1"), 0);
    EXPECT_THROW(scaled(1e-320, 1e-9, "a:1"), contact::InputError);
    EXPECT_THROW(scaled(1e308, 1e3, "a:1"), contact::InputError);
}

std::string kind_in(const std::string& text) {
    const Document document = parse_document(text, "a.toml");
    return std::string(kind_of(document.entries.front().value));
}

TEST(TomlDocument, NumbersTooSmallAreNoZeros) {
    const std::string small = "a number too small for double precision";
    EXPECT_EQ(kind_in("a = 1e-999999999"), small);
    EXPECT_EQ(kind_in("# ä\n\n  [s]\n\"é\" = 1e-400 # 1\n"), small);
    EXPECT_EQ(kind_in("a = [1.0,\n 1e-400, 2.0]"), small);
    EXPECT_EQ(kind_in("t = { x = 2e-400, y = 1 }"), small);
    EXPECT_EQ(kind_in("a = 0.0 # 1e-999"), "a number");
    EXPECT_EQ(kind_in("a = 0.0\nb = 1e-999"), "a number");
    EXPECT_EQ(kind_in("a = [0.0, 1.0]"), "a list of numbers");
    EXPECT_EQ(kind_of(parse_value("1e-400")), small);
    EXPECT_EQ(kind_of(parse_value("[1.5, 1e-400]")), small);
    EXPECT_EQ(kind_of(parse_value("0.0")), "a number");
}

}  // namespace
}  // namespace tricontact::io::number_text_test
