#include "app/sweep_table.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/csv.h"
#include "comparisons/point_results.h"

namespace tricontact::app {

namespace {

using comparisons::csv_field;
using comparisons::csv_line;
using json = nlohmann::ordered_json;

std::string field(const json& value) {
    if (value.is_null()) return {};
    return value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

std::string heading(const io::Study& study) {
    std::vector<std::string> names;
    for (const auto& axis : study.axes) names.push_back(io::table_heading(*axis.key));
    names.insert(names.end(), {"model", "level"});
    const auto& results = comparisons::point_result_names();
    names.insert(names.end(), results.begin(), results.end());
    names.emplace_back("error");
    return csv_line(names);
}

}  // namespace

std::string sweep_table(const io::Study& study, const std::vector<SweepPoint>& points,
                        const io::ResultStore& store) {
    std::string table = heading(study);
    for (const SweepPoint& point : points) {
        std::vector<std::string> fields;
        for (const std::string& value : point.values) fields.push_back(csv_field(value));
        fields.insert(fields.end(), {point.model, std::to_string(point.level)});
        const auto outcome = store.find(point.key);
        json results = json::object();
        if (outcome && outcome->results) results = json::parse(*outcome->results);
        for (const std::string& name : comparisons::point_result_names())
            fields.push_back(field(results.value(name, json())));
        fields.push_back(outcome && outcome->error ? csv_field(*outcome->error) : "");
        table += csv_line(fields);
    }
    return table;
}

}  // namespace tricontact::app
