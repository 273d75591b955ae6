#include "report/document_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace tricontact::report {

namespace {

[[noreturn]] void refuse(const std::string& owner, const std::string& rule) {
    throw std::invalid_argument(fmt::format("document: {}: {}", owner, rule));
}

bool is_word_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

/// Ids become names of files and targets of links.
void check_id(const std::string& kind, const std::string& id, std::set<std::string>& known) {
    const std::string owner = fmt::format("{} '{}'", kind, id);
    if (id.empty() || !std::ranges::all_of(id, is_word_letter))
        refuse(owner, "an id consists of letters, digits, hyphens and underscores");
    if (!known.insert(id).second) refuse(owner, "the id occurs twice");
}

void check_lengths(const std::string& owner, std::size_t n, const std::vector<double>& values) {
    if (values.size() != n)
        refuse(owner, fmt::format("{} values where x has {}", values.size(), n));
}

void check_curves(const std::string& owner, const std::vector<Curve>& curves) {
    for (const Curve& curve : curves) {
        check_lengths(owner, curve.x.size(), curve.y);
        for (const auto& errors : {curve.x_error, curve.y_error})
            if (!errors.empty()) check_lengths(owner, curve.x.size(), errors);
    }
}

template <class T>
void check_grid(const std::string& owner, const std::vector<double>& x,
                const std::vector<double>& y, const std::vector<T>& values) {
    if (values.size() != x.size() * y.size())
        refuse(owner,
               fmt::format("{} values on a grid of {} by {}", values.size(), x.size(), y.size()));
    for (const auto& axis : {x, y})
        if (!std::is_sorted(axis.begin(), axis.end(), std::less_equal<>()))
            refuse(owner, "the grid of a map increases along both axes");
}

void check_figure(const Figure& figure) {
    const std::string owner = "figure '" + figure.id + "'";
    check_curves(owner, figure.curves);
    for (const Band& band : figure.bands) {
        check_lengths(owner, band.x.size(), band.low);
        check_lengths(owner, band.x.size(), band.high);
    }
    if (figure.map) check_grid(owner, figure.map->x, figure.map->y, figure.map->values);
    const auto check_kind = [&](std::size_t kind) {
        if (kind >= figure.kinds.size()) refuse(owner, fmt::format("there is no kind {}", kind));
    };
    for (const Strip& strip : figure.strips)
        for (const Strip::Stretch& stretch : strip.stretches) check_kind(stretch.kind);
    for (const Panel& panel : figure.panels) {
        check_grid(owner, panel.x, panel.y, panel.kinds);
        check_curves(owner, panel.curves);
        for (const int kind : panel.kinds)
            if (kind >= 0) check_kind(static_cast<std::size_t>(kind));
    }
}

void check_table(const DocumentTable& table) {
    for (const auto& row : table.rows)
        if (row.size() != table.columns.size())
            refuse("table '" + table.id + "'", fmt::format("a row of {} cells under {} headings",
                                                           row.size(), table.columns.size()));
}

}  // namespace

void check_document(const Document& document) {
    // Sections share the page with the template's own anchors.
    std::set<std::string> sections{"content", "verdicts", "setting", "origin"}, figures, tables;
    for (const DocumentSection& section : document.sections) {
        check_id("section", section.id, sections);
        for (const Figure& figure : section.figures) {
            check_id("figure", figure.id, figures);
            check_figure(figure);
        }
        for (const DocumentTable& table : section.tables) {
            check_id("table", table.id, tables);
            check_table(table);
        }
    }
}

}  // namespace tricontact::report
