// Texts in tables: no spreadsheet computes one, and each is read back as it was.

#include "report/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tricontact::report::csv_test {
namespace {

// As csv.h says: RFC 4180, then without the apostrophe that stands before.
std::string read_back(std::string field) {
    if (field.starts_with('"')) {
        std::string text;
        for (std::size_t i = 1; i + 1 < field.size(); ++i) {
            text += field[i];
            if (field[i] == '"') ++i;
        }
        field = text;
    }
    return field.starts_with('\'') ? field.substr(1) : field;
}

TEST(Csv, FormulasAreTexts) {
    EXPECT_EQ(csv_field("=1+1"), "'=1+1");
    EXPECT_EQ(csv_field("=HYPERLINK(\"a\",\"b\")"), "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\"");
    EXPECT_EQ(csv_field("@SUM(A1)"), "'@SUM(A1)");
    EXPECT_EQ(csv_field("+cmd|' /C calc'!A0"), "'+cmd|' /C calc'!A0");
    EXPECT_EQ(csv_field("-2+3"), "'-2+3");
    EXPECT_EQ(csv_field("\t=1"), "'\t=1");
    EXPECT_EQ(csv_field("\r=1"), "\"'\r=1\"");
    EXPECT_EQ(csv_field("'quoted'"), "''quoted'");
    for (const char* plain : {"", "-1.5e-3", "+2", "-0", "bem-layer", "a=b", "1 mm", "± 2"})
        EXPECT_EQ(csv_field(std::string(plain)), plain);
}

RC_GTEST_PROP(Csv, EveryTextIsReadBack, ()) {
    const auto letters = rc::gen::element('=', '+', '-', '@', '\t', '\'', '"', ',', '\n', '1', 'a');
    const std::string text = *rc::gen::container<std::string>(letters);
    const std::string field = csv_field(text);
    RC_ASSERT(read_back(field) == text);
    const std::string shown = field.starts_with('"') ? field.substr(1) : field;
    const bool number = !shown.empty() && shown.find_first_not_of("+-1") == std::string::npos;
    // In RC_ASSERT the operands of || are all evaluated.
    const bool harmless =
        number || shown.empty() || std::string("=@\t").find(shown.front()) == std::string::npos;
    RC_ASSERT(harmless);
}

}  // namespace
}  // namespace tricontact::report::csv_test
