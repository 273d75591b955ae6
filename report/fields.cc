#include "report/fields.h"

namespace tricontact::report {

Cell cell_of(const nlohmann::ordered_json& value, double unit, const nlohmann::ordered_json& bar) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_integer()) return value.get<int>();
    if (!value.is_number()) return number_cell({});
    const double number = value.get<double>() / unit;
    if (bar.is_number()) return WithError{number, bar.get<double>() / unit};
    return number;
}

std::string csv_value(const nlohmann::ordered_json& value) {
    if (value.is_string()) return csv_field(value.get<std::string>());
    if (value.is_number_float()) return csv_field(value.get<double>());
    return value.is_null() ? "" : csv_field(value.dump());
}

}  // namespace tricontact::report
