#include "report/document_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

std::string series_of(const Curve& curve) {
    if (curve.detail.empty()) return curve.name;
    return curve.name.empty() ? curve.detail : curve.name + ", " + curve.detail;
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
        const std::string name = series_of(curve);
        const std::string heading = name.empty() ? figure.y.label : name + ": " + figure.y.label;
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

/// What is drawn as one table, a row per point, cell or stretch with the name of its series: where
/// a figure holds more than curves over one axis. Columns without a value are left out.
class LongTable {
  public:
    explicit LongTable(const Figure& figure) {
        const std::string &of_x = figure.x.label, &of_y = figure.y.label;
        headings_ = {"series",    of_x,           "to " + of_x,    "± " + of_x, of_y,
                     "± " + of_y, of_y + ", low", of_y + ", high", "value",     "kind"};
        if (figure.map) headings_[value] = figure.map->label;
        if (figure.map) add_map(*figure.map);
        for (const Curve& curve : figure.curves) add_curve(series_of(curve), curve);
        for (const Band& band : figure.bands) add_band(band);
        for (const Strip& strip : figure.strips) add_strip(strip, figure.kinds);
        for (const Panel& panel : figure.panels) add_panel(panel, figure.kinds);
    }
    std::string text() const {
        std::string text = line(headings_);
        for (const Row& row : rows_) text += line(row);
        return text;
    }

  private:
    enum Place { series, x, x_end, x_error, y, y_error, low, high, value, kind, n_places };
    using Row = std::array<std::string, n_places>;

    Row& add(const std::string& name, double at) {
        Row& row = rows_.emplace_back();
        set(row, series, name);
        set(row, x, at);
        return row;
    }
    template <class Value>
    void set(Row& row, Place place, const Value& content) {
        row[place] = csv_field(content);
        is_used_[place] = is_used_[place] || !row[place].empty();
    }
    void add_curve(const std::string& name, const Curve& curve) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            Row& row = add(name, curve.x[i]);
            set(row, y, curve.y[i]);
            if (!curve.x_error.empty()) set(row, x_error, curve.x_error[i]);
            if (!curve.y_error.empty()) set(row, y_error, curve.y_error[i]);
        }
    }
    void add_band(const Band& band) {
        for (std::size_t i = 0; i < band.x.size(); ++i) {
            Row& row = add(band.name, band.x[i]);
            set(row, low, band.low[i]);
            set(row, high, band.high[i]);
        }
    }
    void add_map(const ContourMap& map) {
        auto of_node = map.values.begin();
        for (const double at_y : map.y)
            for (const double at_x : map.x) {
                Row& row = add("map", at_x);
                set(row, y, at_y);
                set(row, value, *of_node++);
            }
    }
    void add_strip(const Strip& strip, const std::vector<Kind>& kinds) {
        for (const auto& [of, begin, end] : strip.stretches) {
            Row& row = add(strip.name, begin);
            set(row, x_end, end);
            set(row, kind, kinds[of].name);
        }
    }
    void add_panel(const Panel& panel, const std::vector<Kind>& kinds) {
        auto of_cell = panel.kinds.begin();
        for (const double at_y : panel.y)
            for (const double at_x : panel.x)
                if (const int of = *of_cell++; of >= 0) {
                    Row& row = add(panel.title, at_x);
                    set(row, y, at_y);
                    set(row, kind, kinds[static_cast<std::size_t>(of)].name);
                }
        for (std::size_t i = 0; i < panel.curves.size(); ++i)
            add_curve(fmt::format("{}, outline {}", panel.title, i + 1), panel.curves[i]);
    }
    std::string line(const Row& row) const {
        std::vector<std::string> fields;
        for (int place = 0; place < n_places; ++place)
            if (is_used_[place]) fields.push_back(row[place]);
        return csv_line(fields);
    }

    Row headings_;
    std::array<bool, n_places> is_used_{};
    std::vector<Row> rows_;
};

}  // namespace

std::string figure_csv(const Figure& figure) {
    const bool has_curves = !figure.curves.empty() || !figure.bands.empty();
    if (!figure.panels.empty() || !figure.strips.empty() || (figure.map && has_curves))
        return LongTable(figure).text();
    if (figure.map) return map_csv(figure);
    const auto columns = columns_of(figure);
    return columns.empty() ? "" : table_of(columns);
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
