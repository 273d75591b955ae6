#include "comparisons/csv.h"

#include <fmt/format.h>

#include <cmath>

namespace tricontact::comparisons {

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string csv_field(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string csv_field(const std::optional<double>& value) {
    return value ? csv_field(*value) : "";
}

std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) line.append(i > 0 ? "," : "").append(fields[i]);
    return line + '\n';
}

}  // namespace tricontact::comparisons
