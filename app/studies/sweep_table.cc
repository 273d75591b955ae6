#include "app/studies/sweep_table.h"

#include <nlohmann/json.hpp>

#include "report/csv.h"

namespace tricontact::app {

namespace {

using report::csv_field;
using report::csv_line;
using json = nlohmann::ordered_json;

std::string field(const json& value) {
    if (value.is_null()) return {};
    return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

std::string line_of(const TableRow& row, const std::vector<std::string>& result_names,
                    const io::ResultStore& store) {
    std::vector<std::string> fields;
    for (const std::string& text : row.fields) fields.push_back(csv_field(text));
    const auto outcome = store.find(row.key);
    json results = json::object();
    if (outcome && outcome->results) results = json::parse(*outcome->results);
    for (const std::string& name : result_names)
        fields.push_back(field(results.value(name, json())));
    fields.push_back(outcome && outcome->error ? csv_field(*outcome->error) : "");
    return csv_line(fields);
}

}  // namespace

std::string sweep_table(const std::vector<std::string>& headings,
                        const std::vector<std::string>& result_names,
                        const std::vector<TableRow>& rows, const io::ResultStore& store) {
    std::vector<std::string> names = headings;
    names.insert(names.end(), result_names.begin(), result_names.end());
    names.emplace_back("error");
    std::string table = csv_line(names);
    for (const TableRow& row : rows) table += line_of(row, result_names, store);
    return table;
}

}  // namespace tricontact::app
