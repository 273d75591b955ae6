#include "report/json_table.h"

#include <nlohmann/json.hpp>

#include "report/csv.h"
#include "report/format.h"

namespace tricontact::report {

namespace {

using Json = nlohmann::ordered_json;

const Json& value_at(const Json& result, const std::string& key) {
    return key.starts_with('/') ? result.at(Json::json_pointer(key)) : result.at(key);
}

std::string csv_value(const Json& value) {
    if (value.is_string()) return csv_field(value.get<std::string>());
    if (value.is_number_float()) return csv_field(value.get<double>());
    return value.is_null() ? "" : csv_field(value.dump());
}

}  // namespace

Cell cell_of(const Json& value, double unit, const Json& bar) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_integer()) return value.get<int>();
    if (value.is_object() && value.contains("low"))
        return cell_of(value["value"], unit,
                       (value["high"].get<double>() - value["low"].get<double>()) / 2);
    if (value.is_object()) return cell_of(value.at("value"), unit, value.at("standard_error"));
    if (!value.is_number()) return number_cell({});
    const double number = value.get<double>() / unit;
    if (bar.is_number()) return WithError{number, bar.get<double>() / unit};
    return number;
}

DocumentTable table_of(DocumentTable head, const Json& results,
                       const std::vector<ValueColumn>& columns) {
    for (const ValueColumn& one : columns) head.columns.push_back(column(one.heading));
    for (const Json& result : results) {
        auto& row = head.rows.emplace_back();
        for (const auto& [key, heading, unit, bar] : columns) {
            const Json& value = value_at(result, key);
            if (key == "model")
                row.emplace_back(display_name(value));
            else
                row.push_back(cell_of(value, unit, bar.empty() ? Json() : value_at(result, bar)));
        }
    }
    return head;
}

std::string csv_of(const Json& results, const std::vector<std::string>& keys) {
    std::string text = csv_line(keys);
    for (const Json& result : results) {
        std::vector<std::string> fields;
        for (const std::string& key : keys) fields.push_back(csv_value(value_at(result, key)));
        text += csv_line(fields);
    }
    return text;
}

}  // namespace tricontact::report
