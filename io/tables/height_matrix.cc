// Height maps as text: rows of numbers, what programs write above them, and what contradicts the
// case.

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "io/keys/messages.h"
#include "io/keys/units.h"
#include "io/tables/csv_header.h"
#include "io/tables/height_map_file.h"
#include "io/tables/map_layout.h"

namespace tricontact::io {

namespace {

std::string matrix_place(const std::string& name, std::size_t line) {
    return name + ':' + std::to_string(line);
}

std::string lower_case(std::string_view text) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [](unsigned char c) { return std::tolower(c); });
    return out;
}

/// "5.00 um" in metres; empty if it is no length.
std::optional<double> length_in(std::string_view text) {
    try {
        return parse_quantity(text, Dimension::length);
    } catch (const QuantityError&) {
        return {};
    }
}

/// Gwyddion's comments say the size and the unit, and so does the header of a list.
struct Told {
    std::optional<double> width, height, unit;  // [m]
    std::string unit_text;
};

Told told_in(const CsvLines& text) {
    Told told;
    for (const TextLine& comment : text.comments) {
        const auto colon = comment.text.find(':');
        if (colon == std::string_view::npos) continue;
        const std::string key =
            lower_case(trimmed(comment.text.substr(0, colon).substr(comment.text.find('#') + 1)));
        const std::string_view value = trimmed(comment.text.substr(colon + 1));
        if (key == "width") told.width = length_in(value);
        if (key == "height") told.height = length_in(value);
        if (key == "value units") {
            told.unit = length_in("1 " + std::string(value));
            told.unit_text = value;
        }
    }
    return told;
}

/// A size counts nodes or the gaps between them.
void check_side(const char* word, std::optional<double> told, int n, double spacing,
                const std::string& name) {
    constexpr double rounding = .01;  // of a size that is printed with few digits
    const auto agrees = [&](double of) { return std::abs(of / *told - 1) <= rounding; };
    if (!told || agrees(n * spacing) || agrees((n - 1) * spacing)) return;
    fail(name, "",
         std::string("its comments state ") + word + " " + shortest(*told) + " m, but " +
             std::to_string(n) + " nodes " + shortest(spacing) + " m apart take " +
             shortest(n * spacing) + " m",
         "correct indenter.spacing");
}

void check_unit(std::optional<double> told, const std::string& text, double unit,
                const std::string& name) {
    if (!told || std::abs(*told / unit - 1) < 1e-9) return;
    fail(name, "",
         "states heights in " + shortened(text, 20) + ", but indenter.unit is " + shortest(unit) +
             " m",
         "correct indenter.unit");
}

/// Names of the columns of a list of nodes, perhaps with units: "x [mm], y [mm], z [um]".
bool names_nodes(const std::vector<std::string_view>& cells, const HeightMapScale& scale,
                 const std::string& name) {
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    if (cells.size() != axes.size()) return false;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const auto open = cells[k].find_first_of("[(");
        if (lower_case(trimmed(cells[k].substr(0, open))) != axes[k]) return false;
        if (k < 2 || open == std::string_view::npos) continue;
        const auto unit = cells[k].substr(open + 1, cells[k].find_first_of("])") - open - 1);
        check_unit(length_in("1 " + std::string(unit)), std::string(unit), scale.unit, name);
    }
    return true;
}

/// Whether most of a line is no numbers: missing values and corners are fewer.
bool is_text_line(const std::vector<std::string_view>& cells) {
    DecimalReader any("");
    const auto n = std::ranges::count_if(
        cells, [&](std::string_view cell) { return !cell.empty() && !any.number(cell, 0); });
    return 2 * n > std::ssize(cells);
}

}  // namespace

double height_in(std::string_view word, DecimalReader& numbers, const std::string& name,
                 std::size_t line) {
    const auto value = numbers.number(trimmed(word), line);
    if (!value || !std::isfinite(*value))
        fail(matrix_place(name, line), toml_string(shortened(word, 40)),
             "is no finite number: missing values are not filled in", "interpolate them first");
    return *value;
}

contact::HeightMap parse_height_matrix(std::string_view text, const std::string& name,
                                       const HeightMapScale& scale) {
    constexpr auto most_rows = static_cast<std::size_t>(most_height_nodes) + 2;
    const CsvLines found = csv_lines(text, most_rows);
    NumberMatrix numbers;
    DecimalReader reader(name);
    char divider = 0;  // as the first row has it
    bool trailing = false;
    for (const TextLine& line : found.lines) {
        // Between two commas an empty cell is a missing value, between blanks there is none.
        if (divider == 0) divider = divider_of(line.text);
        auto cells = divided_cells(line.text, divider, matrix_place(name, line.number));
        if (numbers.n_rows == 0) {
            if (is_text_line(cells)) {
                const auto place = matrix_place(name, line.number);
                if (!names_nodes(heading_cells(line.text, divider, place), scale, name))
                    fail(place, toml_string(shortened(line.text, 40)),
                         "a line of text stands above the heights",
                         "begin it with #, or remove it");
                divider = 0;
                continue;
            }
            trailing = cells.size() > 2 && cells.back().empty();
        }
        if (trailing && cells.back().empty()) cells.pop_back();
        if (numbers.n_rows > 0 && cells.size() != numbers.n_columns)
            fail(matrix_place(name, line.number), "",
                 "has " + std::to_string(cells.size()) + " heights, but the rows above have " +
                     std::to_string(numbers.n_columns),
                 "make all rows alike");
        for (const auto cell : cells) {
            // A corner between coordinates has no number, or a word.
            const bool corner = numbers.value.empty() && cells.size() > 3 &&
                                !reader.number(cell, line.number) && found.lines.size() > 3;
            const double value = corner ? NAN : height_in(cell, reader, name, line.number);
            if (!corner) scaled(value, scale.unit, matrix_place(name, line.number));
            numbers.value.push_back(value);
        }
        numbers.n_columns = cells.size();
        ++numbers.n_rows;
        // A list of nodes has three numbers of each.
        if (static_cast<double>(numbers.n_columns) * static_cast<double>(numbers.n_rows) >
            (numbers.n_columns == 3 ? 3 : 1) * (most_height_nodes + 2 * 4097))
            fail(matrix_place(name, line.number), "", "more than 4096 x 4096 heights",
                 "thin the surface out, or save a part of it");
    }
    if (numbers.n_columns < 2 || numbers.n_rows < 2)
        fail(name, "",
             "holds " + std::to_string(numbers.n_rows) + " x " + std::to_string(numbers.n_columns) +
                 " heights",
             "give 2 x 2 at least");
    contact::HeightMap map = laid_out(numbers, name, scale, true);
    const Told told = told_in(found);
    check_side("Width:", told.width, map.n_x, map.spacing[0], name);
    check_side("Height:", told.height, map.n_y, map.spacing[1], name);
    check_unit(told.unit, told.unit_text, scale.unit, name);
    return map;
}

}  // namespace tricontact::io
