#include "report/document_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/csv.h"

namespace tricontact::report {

namespace {

struct Column {
    std::string heading;
    std::vector<double> values;
};

std::string table_of(const std::vector<Column>& columns) {
    std::vector<std::string> fields;
    std::size_t n_rows = 0;
    for (const Column& column : columns) {
        fields.push_back(csv_field(column.heading));
        n_rows = std::max(n_rows, column.values.size());
    }
    std::string text = csv_line(fields);
    for (std::size_t row = 0; row < n_rows; ++row) {
        fields.clear();
        for (const Column& column : columns)
            fields.push_back(row < column.values.size() ? csv_field(column.values[row]) : "");
        text += csv_line(fields);
    }
    return text;
}

std::vector<Column> columns_of(const Figure& figure) {
    std::vector<Column> columns;
    const std::vector<double>* last_x = nullptr;
    const auto add_x = [&](const std::vector<double>& x, const std::vector<double>& errors) {
        if (!last_x || *last_x != x || !errors.empty()) columns.push_back({figure.x.label, x});
        if (!errors.empty()) columns.push_back({"± " + figure.x.label, errors});
        last_x = &x;
    };
    for (const Curve& curve : figure.curves) {
        add_x(curve.x, curve.x_error);
        const std::string heading =
            curve.name.empty() ? figure.y.label : curve.name + ": " + figure.y.label;
        columns.push_back({heading, curve.y});
        if (!curve.y_error.empty()) columns.push_back({"± " + heading, curve.y_error});
    }
    for (const Band& band : figure.bands) {
        add_x(band.x, {});
        columns.push_back({band.name + ", low: " + figure.y.label, band.low});
        columns.push_back({band.name + ", high: " + figure.y.label, band.high});
    }
    return columns;
}

std::string map_csv(const Figure& figure) {
    const ContourMap& map = *figure.map;
    std::string text = csv_row(figure.x.label, figure.y.label, map.label);
    auto value = map.values.begin();
    for (const double y : map.y)
        for (const double x : map.x) text += csv_row(x, y, *value++);
    return text;
}

std::string strips_csv(const Figure& figure) {
    std::string text = csv_line({"strip", "kind", "begin", "end"});
    for (const Strip& strip : figure.strips)
        for (const auto& [kind, begin, end] : strip.stretches)
            text += csv_row(strip.name, figure.kinds[kind].name, begin, end);
    return text;
}

std::string field(const Link& link) {
    return csv_field(link.path);
}
std::string field(const WithError& measured) {
    return csv_field(measured.value);
}
template <class Value>
std::string field(const Value& value) {
    return csv_field(value);
}

/// As a matrix: x along the first line, then y and the kinds of its cells.
std::string panel_csv(const Figure& figure, const Panel& panel) {
    std::vector<std::string> fields{
        csv_field(panel.title + ": " + figure.y.label + " \\ " + figure.x.label)};
    for (const double x : panel.x) fields.push_back(csv_field(x));
    std::string text = csv_line(fields);
    auto kind = panel.kinds.begin();
    for (const double y : panel.y) {
        fields = {csv_field(y)};
        for (std::size_t i = 0; i < panel.x.size(); ++i, ++kind)
            fields.push_back(*kind < 0 ? "" : csv_field(figure.kinds[*kind].name));
        text += csv_line(fields);
    }
    return text;
}

}  // namespace

std::string figure_csv(const Figure& figure) {
    std::vector<std::string> parts;
    if (figure.map) parts.push_back(map_csv(figure));
    if (const auto columns = columns_of(figure); !columns.empty())
        parts.push_back(table_of(columns));
    if (!figure.strips.empty()) parts.push_back(strips_csv(figure));
    for (const Panel& panel : figure.panels) parts.push_back(panel_csv(figure, panel));
    return fmt::format("{}", fmt::join(parts, "\n"));
}

std::string table_csv(const DocumentTable& table) {
    const std::size_t n_columns = table.columns.size();
    std::vector<bool> with_errors(n_columns, false);
    for (const auto& row : table.rows)
        for (std::size_t i = 0; i < n_columns; ++i)
            if (std::holds_alternative<WithError>(row[i])) with_errors[i] = true;
    std::vector<std::string> fields;
    for (std::size_t i = 0; i < n_columns; ++i) {
        fields.push_back(csv_field(table.columns[i].heading));
        if (with_errors[i]) fields.push_back(csv_field("± " + table.columns[i].heading));
    }
    std::string text = csv_line(fields);
    for (const auto& row : table.rows) {
        fields.clear();
        for (std::size_t i = 0; i < n_columns; ++i) {
            fields.push_back(std::visit([](const auto& value) { return field(value); }, row[i]));
            const auto* measured = std::get_if<WithError>(&row[i]);
            if (with_errors[i]) fields.push_back(measured ? csv_field(measured->error) : "");
        }
        text += csv_line(fields);
    }
    return text;
}

}  // namespace tricontact::report
