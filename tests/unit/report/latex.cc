#include "report/latex.h"

#include <gtest/gtest.h>

#include <limits>

namespace tricontact::report::latex_test {
namespace {

// Forms of LaTeX's manual: escaped special characters, mathematics between dollar signs.
TEST(Latex, SpecialCharactersAreEscaped) {
    EXPECT_EQ(latex_text("5 % of a & b, #1, $2 {x}"), "5~\\% of a \\& b, \\#1, \\$2 \\{x\\}");
    EXPECT_EQ(latex_text("a_long_name"), "a\\_long\\_name");
    EXPECT_EQ(latex_text("C:\\x ~ y"), "C:\\textbackslash{}x \\textasciitilde{} y");
    EXPECT_EQ(latex_text("\"it's\""), "''it's''");
}

TEST(Latex, SymbolsAreMathematics) {
    EXPECT_EQ(latex_text("f_T,lim"), "$f_{\\mathrm{T,lim}}$");
    EXPECT_EQ(latex_text("mu F_N"), "$\\mu $ $F_{\\mathrm{N}}$");
    EXPECT_EQ(latex_text("a^2"), "a$^{\\mathrm{2}}$");
    EXPECT_EQ(latex_text("w >= 1"), "w $\\geq $ 1");
    EXPECT_EQ(latex_text("a < b > c"), "a $<$ b $>$ c");
}

// A dollar sign before a symbol neither ends nor begins mathematics.
TEST(Latex, DollarSignsStayText) {
    EXPECT_EQ(latex_text("$μ$"), "\\$$\\mu $\\$");
}

TEST(Latex, NumbersAreTypeset) {
    EXPECT_EQ(latex_text("1.20·10⁻⁷"), "1.20$\\cdot $10$^{-7}$");
    EXPECT_EQ(latex_text("−0.83 ± 0.12"), "$-$0.83~$\\pm $~0.12");
    EXPECT_EQ(latex_text("–"), "--");
}

DocumentTable table() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {.id = "points",
            .title = "Points",
            .note = "Two\nlines.",
            .columns = {{"[model]"}, {"u_sd [%]", 3}, {"κ [1]"}},
            .rows = {{std::string("bem"), 0.123456, WithError{1.06, 0.119}},
                     {std::string("*"), nan, WithError{nan, nan}}}};
}

TEST(Latex, ATableHasTheRulesOfBooktabs) {
    EXPECT_EQ(latex_table(table(), "tricontact 0.1.0: tricontact run a.toml"),
              "% tricontact 0.1.0: tricontact run a.toml\n% Points\n% Two\n% lines.\n"
              "% Needs \\usepackage{booktabs}.\n"
              "\\begin{tabular}{lrr}\n\\toprule\n"
              "{}[model] & $u_{\\mathrm{sd}}$ [\\%] & $\\kappa $ [1] \\\\\n\\midrule\n"
              "bem & 0.123 & 1.06~$\\pm $~0.12 \\\\\n{}* & -- & -- \\\\\n"
              "\\bottomrule\n\\end{tabular}\n");
}

}  // namespace
}  // namespace tricontact::report::latex_test
