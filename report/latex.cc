#include "report/latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "report/format.h"
#include "report/table_style.h"

namespace tricontact::report {

namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

// Of what typeset() writes: in text.
constexpr Replacement text_forms[] = {{"&amp;", "\\&"},
                                      {"&apos;", "'"},
                                      {"&quot;", "''"},
                                      {"\u00a0", "~"},
                                      {"\u202f", "\\,"},
                                      {"–", "--"},
                                      {"—", "---"},
                                      {"…", "\\ldots{}"},
                                      {"’", "'"},
                                      {"“", "``"},
                                      {"”", "''"},
                                      {"%", "\\%"},
                                      {"$", "\\$"},
                                      {"#", "\\#"},
                                      {"_", "\\_"},
                                      {"{", "\\{"},
                                      {"}", "\\}"},
                                      {"~", "\\textasciitilde{}"},
                                      {"^", "\\textasciicircum{}"},
                                      {"\\", "\\textbackslash{}"}};

// In mathematics.
constexpr Replacement symbols[] = {
    {"&lt;", "<"},      {"&gt;", ">"},       {"|", "|"},         {"−", "-"},
    {"·", "\\cdot "},   {"×", "\\times "},   {"±", "\\pm "},     {"≥", "\\geq "},
    {"≤", "\\leq "},    {"∞", "\\infty "},   {"°", "^{\\circ}"}, {"µ", "\\mu "},
    {"√", "\\surd "},   {"→", "\\to "},      {"≈", "\\approx "}, {"α", "\\alpha "},
    {"β", "\\beta "},   {"γ", "\\gamma "},   {"δ", "\\delta "},  {"ε", "\\varepsilon "},
    {"ζ", "\\zeta "},   {"η", "\\eta "},     {"θ", "\\theta "},  {"ι", "\\iota "},
    {"κ", "\\kappa "},  {"λ", "\\lambda "},  {"μ", "\\mu "},     {"ν", "\\nu "},
    {"ξ", "\\xi "},     {"π", "\\pi "},      {"ρ", "\\rho "},    {"σ", "\\sigma "},
    {"τ", "\\tau "},    {"υ", "\\upsilon "}, {"φ", "\\varphi "}, {"χ", "\\chi "},
    {"ψ", "\\psi "},    {"ω", "\\omega "},   {"Γ", "\\Gamma "},  {"Δ", "\\Delta "},
    {"Θ", "\\Theta "},  {"Λ", "\\Lambda "},  {"Ξ", "\\Xi "},     {"Π", "\\Pi "},
    {"Σ", "\\Sigma "},  {"Φ", "\\Phi "},     {"Ψ", "\\Psi "},    {"Ω", "\\Omega "},
    {"½", "\\frac12 "}, {"′", "'"}};

// Digits that stand above or below the line.
constexpr Replacement raised[] = {{"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
                                  {"³", "3"}, {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"},
                                  {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
constexpr Replacement lowered[] = {{"₋", "-"}, {"₀", "0"}, {"₁", "1"}, {"₂", "2"},
                                   {"₃", "3"}, {"₄", "4"}, {"₅", "5"}, {"₆", "6"},
                                   {"₇", "7"}, {"₈", "8"}, {"₉", "9"}};
// Tags of typeset(); braces stay balanced where tags are.
constexpr Replacement tags[] = {
    {"<sub>", "_{\\mathrm{"}, {"</sub>", "}}"}, {"<sup>", "^{\\mathrm{"},
    {"</sup>", "}}"},         {"<i>", ""},      {"</i>", ""}};

/// Text and mathematics, changing between them where needed.
class Writer {
  public:
    explicit Writer(const std::string& html) : html_(html) {}

    std::string written() {
        while (at_ < html_.size())
            if (!take_tag() && !take_digits(raised, "^{") && !take_digits(lowered, "_{") &&
                !take_symbol() && !take_text())
                put(html_[at_++]);
        set_math(false);
        return std::move(latex_);
    }

  private:
    template <class Table>
    const Replacement* found(const Table& table) const {
        const auto* one = std::ranges::find_if(table, [&](const Replacement& pair) {
            return html_.compare(at_, pair.first.size(), pair.first) == 0;
        });
        return one == std::end(table) ? nullptr : one;
    }
    bool take_tag() {
        const Replacement* tag = found(tags);
        if (!tag) return false;
        const bool closes = tag->first.starts_with("</");
        if (!closes) set_math(true);
        latex_ += tag->second;
        depth_ += closes ? -1 : 1;
        at_ += tag->first.size();
        return true;
    }
    template <class Table>
    bool take_digits(const Table& table, const char* begin) {
        if (!found(table)) return false;
        set_math(true);
        latex_ += begin;
        while (const Replacement* digit = found(table)) {
            latex_ += digit->second;
            at_ += digit->first.size();
        }
        latex_ += '}';
        return true;
    }
    bool take_symbol() {
        const Replacement* symbol = found(symbols);
        if (!symbol) return false;
        set_math(true);
        latex_ += symbol->second;
        at_ += symbol->first.size();
        return true;
    }
    bool take_text() {
        const Replacement* text = found(text_forms);
        if (!text) return false;
        if (depth_ == 0) set_math(false);
        latex_ += text->second;
        at_ += text->first.size();
        return true;
    }
    void put(char c) {
        if (depth_ == 0) set_math(false);
        latex_ += c;
    }
    void set_math(bool math) {
        if (math != is_math_) latex_ += '$';
        is_math_ = math;
    }

    const std::string& html_;
    std::string latex_;
    std::size_t at_ = 0;
    int depth_ = 0;  // of tags
    bool is_math_ = false;
};

/// A line of cells. Behind the end of a line a bracket or a star would belong to it.
std::string row_of(const std::vector<std::string>& cells) {
    const std::string text = fmt::format("{}", fmt::join(cells, " & "));
    return (text.starts_with('[') || text.starts_with('*') ? "{}" : "") + text + " \\\\\n";
}

std::string comment(const std::string& text) {
    if (text.empty()) return "";
    std::string lines = "% ";
    for (const char c : text) lines += c == '\n' ? std::string("\n% ") : std::string(1, c);
    return lines + '\n';
}

}  // namespace

std::string latex_text(const std::string& sentence) {
    return Writer(typeset(sentence)).written();
}

std::string latex_table(const DocumentTable& table, const std::string& provenance) {
    std::string places, rows;
    std::vector<ColumnStyle> styles;
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        styles.push_back(style_of(table, i));
        places += styles[i].words ? 'l' : 'r';
        cells.push_back(latex_text(table.columns[i].heading));
    }
    const std::string heading = row_of(cells);
    for (const std::vector<Cell>& row : table.rows) {
        cells.clear();
        for (std::size_t i = 0; i < row.size(); ++i)
            cells.push_back(latex_text(cell_text(row[i], styles[i])));
        rows += row_of(cells);
    }
    return comment(provenance) + comment(table.title) + comment(table.note) +
           comment("Needs \\usepackage{booktabs}.") +
           fmt::format(
               "\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\midrule\n{}\\bottomrule\n"
               "\\end{{tabular}}\n",
               places, heading, rows);
}

}  // namespace tricontact::report
