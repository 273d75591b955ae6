#include "app/sweep_table.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/point_results.h"

namespace tricontact::app {

namespace {

using json = nlohmann::ordered_json;

/// RFC 4180: quotes around what holds commas, quotes or line ends; quotes doubled.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string field(const json& value) {
    if (value.is_null()) return {};
    return value.is_string() ? field(value.get<std::string>()) : value.dump();
}

std::string line_of(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& text : fields) line.append(line.empty() ? "" : ",").append(text);
    return line + '\n';
}

std::string heading(const io::Study& study) {
    std::vector<std::string> names;
    for (const auto& axis : study.axes) names.push_back(io::table_heading(*axis.key));
    names.insert(names.end(), {"model", "level"});
    const auto& results = comparisons::point_result_names();
    names.insert(names.end(), results.begin(), results.end());
    names.emplace_back("error");
    return line_of(names);
}

}  // namespace

std::string sweep_table(const io::Study& study, const std::vector<SweepPoint>& points,
                        const io::ResultStore& store) {
    std::string table = heading(study);
    for (const SweepPoint& point : points) {
        std::vector<std::string> fields;
        for (const std::string& value : point.values) fields.push_back(field(value));
        fields.insert(fields.end(), {point.model, std::to_string(point.level)});
        const auto outcome = store.find(point.key);
        json results = json::object();
        if (outcome && outcome->results) results = json::parse(*outcome->results);
        for (const std::string& name : comparisons::point_result_names())
            fields.push_back(field(results.value(name, json())));
        fields.push_back(outcome && outcome->error ? field(*outcome->error) : "");
        table += line_of(fields);
    }
    return table;
}

}  // namespace tricontact::app
