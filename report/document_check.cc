#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "report/document.h"

namespace tricontact::report {

namespace {

[[noreturn]] void refuse(const std::string& owner, const std::string& rule) {
    throw std::invalid_argument(fmt::format("document: {}: {}", owner, rule));
}

/// Ids become names of files and targets of links. What messages call the owner: "figure 'a'".
std::string check_id(const std::string& kind, const std::string& id, std::set<std::string>& known) {
    const std::string owner = fmt::format("{} '{}'", kind, id);
    constexpr const char* word = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
    if (id.empty() || id.find_first_not_of(word) != std::string::npos)
        refuse(owner, "an id consists of letters, digits, hyphens and underscores");
    if (!known.insert(id).second) refuse(owner, "the id occurs twice");
    return owner;
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

void check_grid(const std::string& owner, const std::vector<double>& x,
                const std::vector<double>& y, const auto& values) {
    if (values.size() != x.size() * y.size())
        refuse(owner,
               fmt::format("{} values on a grid of {} by {}", values.size(), x.size(), y.size()));
    for (const auto& axis : {x, y})
        if (!std::is_sorted(axis.begin(), axis.end(), std::less_equal<>()))
            refuse(owner, "the grid of a map increases along both axes");
}

void check_figure(const std::string& owner, const Figure& figure) {
    check_curves(owner, figure.curves);
    for (const Band& band : figure.bands)
        for (const auto& side : {band.low, band.high}) check_lengths(owner, band.x.size(), side);
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

}  // namespace

void check_document(const Document& document) {
    // Sections share the page with the template's own anchors.
    std::set<std::string> sections{"content", "answer", "player", "setting", "origin"}, figures,
        tables;
    const auto check_table = [&](const DocumentTable& table) {
        const std::string owner = check_id("table", table.id, tables);
        const std::size_t n = table.columns.size();
        for (const auto& row : table.rows)
            if (row.size() != n)
                refuse(owner, fmt::format("a row of {} cells under {} headings", row.size(), n));
    };
    if (document.figure)
        check_figure(check_id("figure", document.figure->id, figures), *document.figure);
    if (document.comparison) check_table(*document.comparison);
    for (const DocumentSection& section : document.sections) {
        check_id("section", section.id, sections);
        for (const Figure& figure : section.figures)
            check_figure(check_id("figure", figure.id, figures), figure);
        for (const DocumentTable& table : section.tables) check_table(table);
    }
}

}  // namespace tricontact::report
