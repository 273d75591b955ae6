// A refinement as files, on a terminal and in a report.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/change_table.h"
#include "comparisons/resolution/refinement.h"
#include "contact/models/model_kind.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_number.h"
#include "report/table_text.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;
using Value = std::optional<double>;

bool has_exact(const Refinement& r) {
    return std::ranges::any_of(r.quantities, [](const auto& q) { return q.exact.has_value(); });
}

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

/// Of lengths and forces with a prefix; ratios have none.
report::Unit unit_for(const RefinedQuantity& q) {
    if (*q.quantity->unit == '\0') return {1, unit_of(*q.quantity)};
    return report::fitting_unit(q.values.back(), q.quantity->unit);
}

std::string error_sentence(const Refinement& r) {
    const RefinedQuantity* worst = nullptr;
    const auto share_of = [](const RefinedQuantity& q) {
        return q.values.back() == 0 ? 0 : q.limit.error / std::abs(q.values.back());
    };
    for (const RefinedQuantity& q : r.quantities)
        if (!worst || share_of(q) > share_of(*worst)) worst = &q;
    if (!worst) return {};
    return fmt::format("The estimated error of the finest level is at most {} (of {}).",
                       relative(worst->limit.error, worst->values.back()), worst->quantity->symbol);
}

std::string doubt_sentence(const Refinement& r) {
    std::vector<std::string> doubtful;
    for (const RefinedQuantity& q : r.quantities)
        if (q.limit.convergence == Convergence::oscillating ||
            q.limit.convergence == Convergence::irregular)
            doubtful.push_back(q.quantity->symbol);
    if (doubtful.empty()) return {};
    return fmt::format(
        "No order can be relied on for {}: nothing is extrapolated there, and the error is twice "
        "the spread of the last three values.",
        fmt::join(doubtful, ", "));
}

std::string unordered_sentence(const Refinement& r) {
    std::vector<std::string> counted;
    for (const RefinedQuantity& q : r.quantities)
        if (q.limit.convergence == Convergence::unordered) counted.push_back(q.quantity->symbol);
    if (counted.empty()) return {};
    const bool springs = contact::model_kind(r.model).is_on_line();
    return fmt::format(
        "{}: errors have either sign and no order ({}); nothing is extrapolated there, and the "
        "error is 1.25 times the spread of the last three values.",
        fmt::join(counted, ", "),
        springs ? "they depend on where between two springs the contact ends"
                : "counted in cells or elements");
}

/// The levels' sizes: of cells and elements, between springs.
std::string levels_sentence(const Refinement& r) {
    const bool springs = contact::model_kind(r.model).is_on_line();
    return fmt::format(
        "{} was refined on {} levels{} from {} to {}{}; the figures and tables of this report are "
        "those of the finest.",
        r.key, r.sizes.size(), springs ? ", springs" : "",
        report::quantity(r.sizes.front(), "m", 3), report::quantity(r.sizes.back(), "m", 3),
        springs ? " apart" : "");
}

std::string exact_sentence(const Refinement& r) {
    std::vector<std::string> within, outside;
    for (const RefinedQuantity& q : r.quantities) {
        if (!q.exact) continue;
        const double error = std::abs(q.values.back() - *q.exact);
        if (q.limit.convergence == Convergence::unchanged && error <= q.limit.error)
            continue;  // prescribed
        (error <= q.limit.error ? within : outside)
            .push_back(fmt::format("{} ({})", q.quantity->symbol,
                                   report::percent(q.values.back() / *q.exact)));
    }
    std::string text;
    if (!within.empty())
        text = fmt::format("Theory ({}) lies within the estimated error of {}.", r.exact_name,
                           fmt::join(within, ", "));
    if (!outside.empty())
        text += fmt::format("{}Theory ({}) lies outside the estimated error of {}.",
                            text.empty() ? "" : " ", r.exact_name, fmt::join(outside, ", "));
    return text;
}

std::string wide_sentence(const Refinement& r) {
    if (!(r.wide_factor > 0)) return {};
    const RefinedQuantity* most = nullptr;
    for (const RefinedQuantity& q : r.quantities)
        if (q.wide_change() &&
            (!most || std::abs(*q.wide_change()) > std::abs(*most->wide_change())))
            most = &q;
    if (!most) return {};
    return fmt::format(
        "A block {} times as wide and deep, at the level before the finest, changes them by at "
        "most {} (of {}).",
        report::significant(r.wide_factor, 2), report::percent(1 + *most->wide_change()),
        most->quantity->symbol);
}

std::string tip_sentence(const Refinement& r) {
    if (!r.infinite_pressure) return {};
    return "The pressure under a conical tip is infinite: p_0 of a mesh has no limit and is left "
           "out.";
}

std::vector<report::Cell> table_row(const Refinement& r, const RefinedQuantity& q) {
    const report::Unit unit = unit_for(q);
    std::vector<report::Cell> row{label_of(*q.quantity), unit.symbol};
    const auto add = [&](Value value) { row.push_back(report::number_cell(value, unit.factor)); };
    const bool ordered = q.limit.convergence == Convergence::ordered;
    for (const double value : q.values) add(value);
    row.emplace_back(name_of(q.limit.convergence));
    row.push_back(report::number_cell(q.limit.order));
    add(ordered ? Value(q.limit.value) : Value());
    row.emplace_back(relative(q.limit.error, q.values.back()));
    if (has_exact(r)) {
        add(q.exact);
        row.push_back(change_cell(q.values.back(), q.exact));
    }
    if (r.wide_factor > 0) row.emplace_back(100 * q.wide_change().value_or(NAN));
    return row;
}

std::string fields_sentence(const Refinement& r) {
    if (!r.fields.empty()) return {};
    return "Fields have no rows: the last states of the levels are at different instants, or carry "
           "nothing.";
}

json to_json(const RefinedField& f) {
    return {{"changes_l2", f.changes},
            {"observed_order", report::number(f.order)},
            {"error_l2", report::number(f.error_l2)},
            {"largest_error_" + f.unit, report::number(f.error_largest)},
            {"wide_block_change_l2", report::number(f.wide)}};
}

}  // namespace

std::string relative(double error, double value) {
    return value == 0 ? report::significant({}) : report::share(error / std::abs(value));
}

std::vector<std::string> refinement_sentences(const Refinement& r) {
    std::vector<std::string> result{levels_sentence(r)};
    for (const auto& sentence : {error_sentence, doubt_sentence, unordered_sentence, exact_sentence,
                                 wide_sentence, tip_sentence, fields_sentence})
        result.push_back(sentence(r));
    std::erase(result, "");
    return result;
}

report::DocumentTable refinement_table(const Refinement& r) {
    report::DocumentTable table{
        .id = "refinement",
        .title = "Values on finer and finer levels",
        .note =
            "Order: p of v + C h^p through the finest three levels; limit: Richardson's "
            "extrapolation with it. Error: of the finest value, 1.25 times its distance from "
            "the limit with an order of at most 2, of frictional work 1 (Roache's grid convergence "
            "index), but not less than the spread of the last three values, as the contact ends "
            "anywhere between cells; where the sequence is not ordered, twice that spread, where "
            "errors have no order 1.25 times.",
        .columns = quantity_columns()};
    for (const double size : r.sizes) table.columns.push_back({report::quantity(size, "m", 3), 5});
    table.columns.insert(table.columns.end(),
                         {{"sequence"}, {"order", 3}, {"limit", 5}, {"error"}});
    if (has_exact(r)) {
        table.columns.push_back({r.exact_name, 5});
        table.columns.push_back(change_column("finest", r.exact_name));
    }
    if (r.wide_factor > 0) table.columns.push_back({.heading = "wide block [%]", .change = true});
    for (const RefinedQuantity& q : r.quantities) table.rows.push_back(table_row(r, q));
    return table;
}

report::DocumentTable refined_fields_table(const Refinement& r) {
    report::DocumentTable table{
        .id = "refined_fields",
        .title = "Fields of the last state on finer and finer levels",
        .note =
            "Differences of neighbouring levels on the finer grid, root of the integral of their "
            "square over that of the field's. Order: of the last two. Error: of the finest level, "
            "1.25 times what the rest of a sequence of the first order comes to, the least that "
            "the root at the contact's edge leaves; at the worst point, which lies there, that of "
            "the order 1/2 for tractions.",
        .columns = {{"field"}}};
    for (std::size_t k = 0; k + 1 < r.sizes.size(); ++k)
        table.columns.push_back({report::quantity(r.sizes[k], "m", 3) + " to next", 3});
    table.columns.insert(table.columns.end(),
                         {{"order", 3}, {"error over all"}, {"error at the worst point"}});
    if (r.wide_factor > 0) table.columns.push_back({"wide block"});
    for (const RefinedField& f : r.fields) {
        std::vector<report::Cell> row{f.name};
        for (const double change : f.changes) row.emplace_back(report::share(change));
        row.push_back(report::number_cell(f.order));
        row.emplace_back(report::share(f.error_l2));
        row.emplace_back(report::quantity(f.error_largest, f.unit.c_str(), 2));
        if (r.wide_factor > 0) row.emplace_back(f.wide ? report::share(*f.wide) : std::string());
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string refinement_json(const std::string& version, const Refinement& r) {
    json quantities = json::object();
    for (const RefinedQuantity& q : r.quantities) quantities[q.quantity->key] = to_json(q);
    json fields = json::object();
    for (const RefinedField& f : r.fields) fields[f.field] = to_json(f);
    const json document{{"version", version},
                        {"model", r.model},
                        {"key", r.key},
                        {"sizes_m", r.sizes},
                        {"cpu_s", r.cpu_s},
                        {"safety_factor", safety_factor},
                        {"exact_by", r.exact_name},
                        {"wide_block_factor", r.wide_factor > 0 ? json(r.wide_factor) : json()},
                        {"quantities", quantities},
                        {"fields", fields}};
    return document.dump(2) + "\n";
}

std::string refinement_csv(const Refinement& r) {
    std::vector<std::string> heading{"row", "size_m"};
    for (const RefinedQuantity& q : r.quantities) heading.emplace_back(q.quantity->key);
    for (const RefinedField& f : r.fields) heading.push_back(f.field + "_change_l2");
    std::string text = report::csv_line(heading);
    const auto row = [&](const std::string& name, std::optional<double> size, const auto& get,
                         const auto& of_field) {
        std::vector<std::string> fields{name, report::csv_field(size)};
        for (const RefinedQuantity& q : r.quantities) fields.push_back(report::csv_field(get(q)));
        for (const RefinedField& f : r.fields) fields.push_back(report::csv_field(of_field(f)));
        text += report::csv_line(fields);
    };
    using Q = const RefinedQuantity&;
    using F = const RefinedField&;
    const auto none = [](F) { return Value(); };
    for (std::size_t k = 0; k < r.sizes.size(); ++k)
        row(
            fmt::format("level_{}", k), r.sizes[k], [k](Q q) { return q.values[k]; },
            [k](F f) { return k < f.changes.size() ? Value(f.changes[k]) : Value(); });
    row(
        "observed_order", {}, [](Q q) { return q.limit.order; }, [](F f) { return f.order; });
    row(
        "limit", {}, [](Q q) { return q.limit.value; }, none);
    row(
        "error_of_finest", {}, [](Q q) { return q.limit.error; },
        [](F f) { return Value(f.error_l2); });
    row(
        "exact", {}, [](Q q) { return q.exact; }, none);
    if (r.wide_factor > 0)
        row(
            "wide_block", r.sizes[r.sizes.size() - 2], [](Q q) { return q.wide; },
            [](F f) { return f.wide; });
    return text;
}

std::string refinement_text(const Refinement& r) {
    std::string text = report::table_text(refinement_table(r));
    if (!r.fields.empty()) text += '\n' + report::table_text(refined_fields_table(r));
    return text;
}

}  // namespace tricontact::comparisons
