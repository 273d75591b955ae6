#include "io/tables/csv_table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/tables/divided_text.h"

namespace tricontact::io {

namespace {

CsvTable::Column column_of(std::string_view cell) {
    CsvTable::Column column{std::string(cell), {}, {}, {}};
    const auto open = cell.find_first_of("[(");
    const bool closed = open != cell.npos && cell.ends_with(cell[open] == '[' ? ']' : ')');
    if (open != cell.npos && (cell[open] == '[' || closed))
        column.name = trimmed(cell.substr(0, open));
    else
        column.name = cell;
    if (closed) column.unit = trimmed(cell.substr(open + 1, cell.size() - open - 2));
    return column;
}

std::string example(const CsvForm& form) {
    return "write for example " + form.header;
}

double number_in_column(std::string_view cell, std::size_t line, const std::string& column,
                        const std::string& name, DecimalReader& numbers) {
    bool in_range = true;
    const auto value = numbers.number(cell, line, in_range);
    const auto refuse = [&](const char* rule, const char* remedy) {
        fail(name + ':' + std::to_string(line), column + " = " + shortened(cell, 40), rule, remedy);
    };
    if (!in_range) refuse("is too large or too small for double precision", "correct the row");
    if (!value) refuse("must be a number", "write for example 0.21, with a point");
    if (!std::isfinite(*value)) refuse("must be a finite number", "correct or remove the row");
    return *value;
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string name, CsvForm form)
    : name_(std::move(name)), form_(std::move(form)) {
    const CsvLines found = csv_lines(text, form_.most_rows + most_preamble_lines + 3);
    if (found.lines.empty()) fail(name_, "", "the table is empty", example(form_));
    const CsvHeader header = find_header(found, name_);
    if (found.lines.size() > form_.most_rows + header.first_row)
        fail(name_, "", "has more than " + std::to_string(form_.most_rows) + " rows",
             form_.thinning);
    header_place_ = place_of(header.line_number);
    name_columns(header, found);
    read_rows(header, found);
}

void CsvTable::name_columns(const CsvHeader& header, const CsvLines& found) {
    std::vector<std::string> headings = header.headings, units = header.units;
    units.resize(headings.size());
    if (headings.size() > 1 && headings.back().empty()) {
        has_trailing_divider_ = true;
        headings.pop_back();
    }
    if (header.first_row < found.lines.size()) {
        const TextLine& line = found.lines[header.first_row];
        const auto cells = divided_cells(line.text, header.divider, place_of(line.number));
        const bool one_more = cells.size() == headings.size() + 1;
        if (one_more && cells.back().empty()) has_trailing_divider_ = true;
        // R's write.table has no name at all for its quoted numbers of rows.
        if (one_more && !has_trailing_divider_) counts_rows_ = line.text.starts_with('"');
    }
    if (headings.size() > 1 && headings.front().empty()) {
        counts_rows_ = true;
        headings.erase(headings.begin());
        units.erase(units.begin());
    }
    for (std::size_t j = 0; j < headings.size(); ++j) {
        Column column = column_of(headings[j]);
        const std::string shown = "the column " + toml_string(shortened(headings[j], 40));
        if (has(column.name)) refuse_header(shown + " stands twice");
        if (!units[j].empty()) {
            if (column.unit && *column.unit != units[j])
                refuse_header(shown + " has another unit in the row below");
            column.unit = units[j];
        }
        columns_.push_back(std::move(column));
    }
}

void CsvTable::read_rows(const CsvHeader& header, const CsvLines& found) {
    DecimalReader numbers(name_);
    const std::size_t n = columns_.size();
    std::optional<double> count;
    for (std::size_t i = header.first_row; i < found.lines.size(); ++i) {
        const std::size_t line = found.lines[i].number;
        auto cells = divided_cells(found.lines[i].text, header.divider, place_of(line));
        if (has_trailing_divider_ && cells.size() == n + counts_rows_ + 1 && cells.back().empty())
            cells.pop_back();
        if (counts_rows_ && cells.size() == n + 1) {
            const auto value = number_in(cells[0]);
            if (!value || *value != std::floor(*value) || (count && *value <= *count))
                fail(place_of(line), toml_string(shortened(cells[0], 40)),
                     "the first column has no name and does not count the rows",
                     "name it, or write the table without it: row.names = FALSE in R, index=False "
                     "in pandas");
            count = value;
            cells.erase(cells.begin());
        }
        if (cells.size() != n)
            fail(place_of(line), "",
                 "has " + std::to_string(cells.size()) + " columns instead of " + std::to_string(n),
                 header.divider == ',' && cells.size() == 2 * n
                     ? "divide columns by semicolons where numbers have decimal commas"
                     : example(form_));
        lines_.push_back(line);
        for (std::size_t j = 0; j < n; ++j)
            columns_[j].values.push_back(
                number_in_column(cells[j], line, columns_[j].name, name_, numbers));
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
    fail(place_of(lines_.at(row)),
         std::string(column) + " = " + shortest(at(column).values.at(row)), rule, remedy);
}

CsvTable read_csv_table(const std::string& path, const CsvForm& form) {
    const std::string name = std::filesystem::path(path).filename().string();
    return {utf8_text(read_input_file(path, form.kind, form.most_mb), name), name, form};
}

}  // namespace tricontact::io
