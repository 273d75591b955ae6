// A refinement as files and on a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/resolution/refinement.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

json to_json(const RefinedQuantity& q) {
    return {{"values", q.values},
            {"convergence", name_of(q.limit.convergence)},
            {"observed_order", report::number(q.limit.order)},
            {"limit", report::number(q.limit.value)},
            {"error_of_finest", report::number(q.limit.error)},
            {"exact", report::number(q.exact)},
            {"wide_block", report::number(q.wide)},
            {"wide_block_change", report::number(q.wide_change())}};
}

/// `text` in a field of `width` characters (not bytes), to the right.
std::string padded(const std::string& text, int width) {
    const auto characters = std::ranges::count_if(text, [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // not a continuation in UTF-8
    });
    return std::string(std::max(0, width - static_cast<int>(characters)), ' ') + text;
}

std::string text_row(const RefinedQuantity& q, bool with_exact, bool with_wide) {
    const report::Unit unit = report::fitting_unit(q.values.back(), q.quantity->unit);
    const auto shown = [&](std::optional<double> value) {
        return padded(report::significant(value.value_or(NAN) / unit.factor, 6), 10);
    };
    const bool ordered = q.limit.convergence == Convergence::ordered;
    std::string line = fmt::format("{:<8}{:<4}", q.quantity->symbol, unit.symbol);
    for (const double value : q.values) line += shown(value);
    line += padded(report::significant(q.limit.order, 3), 7);
    line += shown(ordered ? q.limit.value : NAN);
    line += padded(relative(q.limit.error, q.values.back()), 12);
    if (with_exact) line += "   " + shown(q.exact);
    if (with_wide) line += padded(report::percent(1 + q.wide_change().value_or(NAN)), 11);
    return line + "  " + (ordered ? "" : name_of(q.limit.convergence));
}

std::string trimmed(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

}  // namespace

std::string refinement_json(const std::string& version, const Refinement& r) {
    json quantities = json::object();
    for (const RefinedQuantity& q : r.quantities) quantities[q.quantity->key] = to_json(q);
    const json document{{"version", version},
                        {"model", r.model},
                        {"key", r.key},
                        {"sizes_m", r.sizes},
                        {"cpu_s", r.cpu_s},
                        {"safety_factor", safety_factor},
                        {"exact_by", r.exact_name},
                        {"wide_block_factor", r.wide_factor > 0 ? json(r.wide_factor) : json()},
                        {"quantities", quantities}};
    return document.dump(2) + "\n";
}

std::string refinement_csv(const Refinement& r) {
    std::vector<std::string> heading{"row", "size_m"};
    for (const RefinedQuantity& q : r.quantities) heading.emplace_back(q.quantity->key);
    std::string text = report::csv_line(heading);
    const auto row = [&](const std::string& name, std::optional<double> size, const auto& get) {
        std::vector<std::string> fields{name, report::csv_field(size)};
        for (const RefinedQuantity& q : r.quantities) fields.push_back(report::csv_field(get(q)));
        text += report::csv_line(fields);
    };
    using Q = const RefinedQuantity&;
    for (std::size_t k = 0; k < r.sizes.size(); ++k)
        row(fmt::format("level_{}", k), r.sizes[k], [k](Q q) { return q.values[k]; });
    row("observed_order", {}, [](Q q) { return q.limit.order; });
    row("limit", {}, [](Q q) { return q.limit.value; });
    row("error_of_finest", {}, [](Q q) { return q.limit.error; });
    row("exact", {}, [](Q q) { return q.exact; });
    if (r.wide_factor > 0)
        row("wide_block", r.sizes[r.sizes.size() - 2], [](Q q) { return q.wide; });
    return text;
}

std::string refinement_text(const Refinement& r) {
    const bool with_exact =
        std::ranges::any_of(r.quantities, [](const auto& q) { return q.exact.has_value(); });
    const bool with_wide = r.wide_factor > 0;
    std::string head = fmt::format("{:<12}", r.key + ", mm");
    for (const double size : r.sizes) head += padded(report::significant(1e3 * size), 10);
    head += padded("order", 7) + padded("limit", 10) + padded("error", 12);
    if (with_exact) head += padded(r.exact_name, 13);
    if (with_wide) head += padded("wide block", 11);
    std::string text = trimmed(head);
    for (const RefinedQuantity& q : r.quantities)
        text += trimmed(text_row(q, with_exact, with_wide));
    return text;
}

}  // namespace tricontact::comparisons
