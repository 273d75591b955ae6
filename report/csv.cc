#include "report/csv.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace tricontact::report {

namespace {

// Spreadsheets compute what begins so, and hide an apostrophe before it.
bool looks_like_formula(const std::string& text) {
    constexpr std::string_view begins = "=+-@\t\r'";
    if (text.empty() || begins.find(text.front()) == begins.npos) return false;
    double number = 0;
    const std::size_t sign = text.front() == '+' ? 1 : 0;
    const char* const end = text.data() + text.size();
    return std::from_chars(text.data() + sign, end, number).ptr != end;
}

}  // namespace

std::string csv_field(const std::string& given) {
    const std::string text = looks_like_formula(given) ? '\'' + given : given;
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

}  // namespace tricontact::report
