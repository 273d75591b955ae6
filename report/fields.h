#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "report/csv.h"
#include "report/document.h"
#include "report/json_number.h"

// A result of several values, each declared once: its object in JSON, its line of CSV and its row
// in tables, which pages and terminal (table_text.h) show, follow from one list.
//
//     Fields<LimitRun> run_fields(const LimitStudy& study) {
//         return {{"value", study.varied().symbol, &LimitRun::value},
//                 {"state", "verdict", [](auto& r) { return contact::name_of(r.state); }},
//                 {"final_shift_m", "U [µm]:5", &LimitRun::final_shift, 1e-6},  // shown in µm
//                 {"slowest_m", &LimitRun::slowest}};                           // in files only
//     }
//     json["runs"] = list_of(runs, [&](auto& run) { return json_of(fields, run); });
//     const std::string csv = csv_of(fields, runs);
//     const DocumentTable table = table_of({.id = "runs", .title = "All runs"}, fields, runs);
//
// What some values need beside the result is a further parameter: Fields<Run, Case>, of which a
// value is [](auto& run, auto& c) { ... } or as above, and json_of(fields, run, c).

namespace tricontact::report {

enum class In { files, json, csv };

/// What goes to JSON of a result, in SI units; null, empty or not finite: undefined. From a member,
/// or a function of the result, or of it and what it belongs to.
template <class T, class... Owner>
class FieldValue {
  public:
    using Json = nlohmann::ordered_json;

    FieldValue() = default;  ///< none
    template <class Of>
    FieldValue(Of of) {
        if constexpr (std::is_invocable_v<Of, const T&, const Owner&...>)
            of_ = std::move(of);
        else
            of_ = [of](const T& result, const Owner&...) -> Json {
                return std::invoke(of, result);
            };
    }
    Json operator()(const T& result, const Owner&... owner) const {
        return of_ ? of_(result, owner...) : Json();
    }

  private:
    std::function<Json(const T&, const Owner&...)> of_;
};

/// One of the values of a result T.
template <class T, class... Owner>
struct Field {
    using Value = FieldValue<T, Owner...>;

    /// In files only.
    Field(std::string key_, Value of_, In in_ = In::files)
        : key(std::move(key_)), of(std::move(of_)), in(in_) {}
    /// `heading`: of a column of tables, with unit and digits as those of columns(); `unit` is its
    /// unit in SI; `bar`: half width of the value's interval.
    Field(std::string key_, std::string heading_, Value of_, double unit_ = 1, Value bar_ = {},
          In in_ = In::files)
        : key(std::move(key_)),
          heading(std::move(heading_)),
          of(std::move(of_)),
          unit(unit_),
          bar(std::move(bar_)),
          in(in_) {}

    bool is_in(In file) const { return !key.empty() && (in == In::files || in == file); }

    std::string key;      ///< in JSON and CSV, with its unit; empty: in tables only
    std::string heading;  ///< empty: in files only
    Value of;
    double unit = 1;
    Value bar;
    In in = In::files;
};
template <class... T>
using Fields = std::vector<Field<T...>>;

/// A value as a cell over its unit: words and counts as they are, "yes" or "no", an undefined
/// number; with its bar where that is a number.
Cell cell_of(const nlohmann::ordered_json& value, double unit = 1,
             const nlohmann::ordered_json& bar = nullptr);
/// A value as a field of CSV.
std::string csv_value(const nlohmann::ordered_json& value);

/// The object of a result, keys in the list's order.
template <class... T>
nlohmann::ordered_json json_of(const Fields<T...>& fields, const T&... of) {
    auto json = nlohmann::ordered_json::object();
    for (const auto& field : fields)
        if (field.is_in(In::json)) json[field.key] = field.of(of...);
    return json;
}

/// The line of CSV with the keys, and that of one result.
template <class... T>
std::string csv_heading(const Fields<T...>& fields) {
    std::vector<std::string> keys;
    for (const auto& field : fields)
        if (field.is_in(In::csv)) keys.push_back(field.key);
    return csv_line(keys);
}
template <class... T>
std::string csv_row_of(const Fields<T...>& fields, const T&... of) {
    std::vector<std::string> values;
    for (const auto& field : fields)
        if (field.is_in(In::csv)) values.push_back(csv_value(field.of(of...)));
    return csv_line(values);
}
/// Both, a line for each result.
template <class Results, class T, class... Owner>
std::string csv_of(const Fields<T, Owner...>& fields, const Results& results,
                   const Owner&... owner) {
    std::string text = csv_heading(fields);
    for (const T& one : results) text += csv_row_of(fields, one, owner...);
    return text;
}

/// Adds the columns of a list to a table, and a row of it.
template <class... T>
void add_columns(DocumentTable& table, const Fields<T...>& fields) {
    for (const auto& field : fields)
        if (!field.heading.empty()) table.columns.push_back(column(field.heading));
}
template <class... T>
void add_row(DocumentTable& table, const Fields<T...>& fields, const T&... of) {
    auto& row = table.rows.emplace_back();
    for (const auto& field : fields)
        if (!field.heading.empty())
            row.push_back(cell_of(field.of(of...), field.unit, field.bar(of...)));
}
/// `head`, which has no columns yet, with a row for each result.
template <class Results, class T, class... Owner>
DocumentTable table_of(DocumentTable head, const Fields<T, Owner...>& fields,
                       const Results& results, const Owner&... owner) {
    add_columns(head, fields);
    for (const T& one : results) add_row(head, fields, one, owner...);
    return head;
}

}  // namespace tricontact::report
