#include "io/tables/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

CsvTable::Column column_of(std::string_view cell) {
    CsvTable::Column column{std::string(cell), {}, {}, {}};
    const auto open = cell.find('[');
    column.name = trimmed(cell.substr(0, open));
    if (open != std::string_view::npos && cell.ends_with(']'))
        column.unit = trimmed(cell.substr(open + 1, cell.size() - open - 2));
    return column;
}

std::string example(const CsvForm& form) {
    return "write for example " + form.header;
}

double number_in_column(std::string_view cell, const std::string& column,
                        const std::string& place) {
    cell = without_plus(cell);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const std::string subject = column + " = " + shortened(cell, 40);
    if (error == std::errc::result_out_of_range)
        fail(place, subject, "is too large or too small for double precision", "correct the row");
    if (error != std::errc() || end != cell.data() + cell.size())
        fail(place, subject, "must be a number", "write for example 0.21, with a point");
    if (!std::isfinite(value))
        fail(place, subject, "must be a finite number", "correct or remove the row");
    return value;
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string name, CsvForm form)
    : name_(std::move(name)), form_(std::move(form)) {
    const std::vector<TextLine> lines = lines_of(text, form_.most_rows + 2);
    if (lines.empty()) fail(name_, "", "the table is empty", example(form_));
    if (lines.size() > form_.most_rows + 1)
        fail(name_, "", "has more than " + std::to_string(form_.most_rows) + " rows",
             form_.thinning);
    const auto place = [&](const TextLine& line) {
        return name_ + ':' + std::to_string(line.number);
    };
    header_place_ = place(lines[0]);
    const char divider = divider_in(lines[0].text, ";\t", ',');
    for (const std::string_view cell : cells_of(lines[0].text, divider)) {
        if (has(column_of(cell).name))
            refuse_header("the column " + toml_string(shortened(cell, 40)) + " stands twice");
        columns_.push_back(column_of(cell));
    }
    for (auto line = lines.begin() + 1; line != lines.end(); ++line) {
        const auto cells = cells_of(line->text, divider);
        if (cells.size() != columns_.size())
            fail(place(*line), "",
                 "has " + std::to_string(cells.size()) + " columns instead of " +
                     std::to_string(columns_.size()),
                 example(form_));
        lines_.push_back(line->number);
        for (std::size_t j = 0; j < cells.size(); ++j)
            columns_[j].values.push_back(
                number_in_column(cells[j], columns_[j].name, place(*line)));
    }
}

const CsvTable::Column* CsvTable::find(std::string_view column) const {
    const auto found = std::ranges::find(columns_, column, &Column::name);
    return found == columns_.end() ? nullptr : &*found;
}

const CsvTable::Column& CsvTable::at(std::string_view column) const {
    if (const Column* found = find(column)) return *found;
    std::vector<std::string_view> names;
    for (const Column& c : columns_) names.push_back(c.name);
    const std::string near(nearest(column, names));
    refuse_header("the column " + std::string(column) + " is missing" +
                  (near.empty() ? "" : " (is " + toml_string(near) + " meant to be it?)"));
}

std::vector<double> CsvTable::values(std::string_view column, Dimension dimension) const {
    const Column& found = at(column);
    const std::string shown = toml_string(shortened(found.heading, 40));
    if (!found.unit && dimension != Dimension::none)
        refuse_header("the column " + shown + " has no unit in brackets");
    if (!found.unit) return found.values;
    std::vector<double> values = found.values;
    try {
        const double factor = parse_quantity("1 " + *found.unit, dimension);
        // 1.1 mm is 1.1 / 1000, the double nearest to 0.0011; 1.1 * 0.001 need not be.
        const double divisor = std::round(1 / factor);
        const bool divide = factor < 1 && 1 / divisor == factor;
        for (std::size_t row = 0; row < values.size(); ++row) {
            const double given =
                std::exchange(values[row], divide ? values[row] / divisor : values[row] * factor);
            if (!std::isfinite(values[row]) || (values[row] == 0 && given != 0))
                refuse_value(row, column, "leaves the range of double precision in SI units",
                             "correct the row");
        }
    } catch (const QuantityError& error) {
        refuse_header(error.rule);
    }
    return values;
}

void CsvTable::check_names(std::initializer_list<std::string_view> known) const {
    for (const Column& column : columns_)
        if (std::ranges::count(known, column.name) == 0)
            refuse_header("unknown column " + toml_string(shortened(column.name, 40)) +
                          "; known are " + joined(known));
}

void CsvTable::check_positive(std::string_view column) const {
    const std::vector<double>& values = at(column).values;
    for (std::size_t row = 0; row < n_rows(); ++row)
        if (!(values[row] > 0))
            refuse_value(row, column, "must be positive", "correct or remove the row");
}

void CsvTable::check_increasing(std::string_view column, const std::string& rule,
                                const std::string& remedy) const {
    const std::vector<double>& values = at(column).values;
    for (std::size_t row = 1; row < n_rows(); ++row)
        if (!(values[row] > values[row - 1])) refuse_value(row, column, rule, remedy);
}

void CsvTable::refuse_header(const std::string& rule) const {
    fail(header_place_, "", rule, example(form_));
}

void CsvTable::refuse_value(std::size_t row, std::string_view column, const std::string& rule,
                            const std::string& remedy) const {
    fail(name_ + ':' + std::to_string(lines_.at(row)),
         std::string(column) + " = " + shortest(at(column).values.at(row)), rule, remedy);
}

CsvTable read_csv_table(const std::string& path, const CsvForm& form) {
    return {read_input_file(path, form.kind, form.most_mb),
            std::filesystem::path(path).filename().string(), form};
}

}  // namespace tricontact::io
