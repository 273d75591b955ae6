#include "io/dma_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "io/input_file.h"
#include "io/messages.h"
#include "io/units.h"

namespace tricontact::io {

namespace {

constexpr std::size_t most_rows = 1000;  // an analysis has dozens
constexpr std::array<std::string_view, 3> names{"frequency", "G'", "G''"};
constexpr const char* header_remedy = "write for example frequency [Hz], G' [MPa], G'' [MPa]";

using Cells = std::array<std::string_view, 3>;

struct Line {
    std::string place;  // file:line
    std::string_view text;
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Lines that say something.
std::vector<Line> lines_of(std::string_view text, const std::string& name) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<Line> lines;
    for (int number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        if (!line.empty() && line[0] != '#')
            lines.push_back({name + ':' + std::to_string(number), line});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

char divider_of(std::string_view header) {
    for (const char divider : {';', '\t'})
        if (header.find(divider) != std::string_view::npos) return divider;
    return ',';
}

Cells cells_of(const Line& line, char divider) {
    Cells cells;
    const auto n =
        static_cast<std::size_t>(std::count(line.text.begin(), line.text.end(), divider)) + 1;
    if (n != cells.size())
        fail(line.place, "", "has " + std::to_string(n) + " columns instead of 3", header_remedy);
    std::string_view rest = line.text;
    for (auto& cell : cells) {
        const auto end = rest.find(divider);
        cell = trimmed(rest.substr(0, end));
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return cells;
}

// The unit of "name [unit]".
std::string_view unit_in(std::string_view cell, std::string_view name, const Line& header) {
    const auto open = cell.find('[');
    const std::string shown = toml_string(shortened(cell, 40));
    if (trimmed(cell.substr(0, open)) != name)
        fail(header.place, "", "the column " + shown + " should be " + std::string(name),
             header_remedy);
    if (open == std::string_view::npos || !cell.ends_with(']'))
        fail(header.place, "", "the column " + shown + " has no unit in brackets", header_remedy);
    return trimmed(cell.substr(open + 1, cell.size() - open - 2));
}

double factor_of(std::string_view unit, Dimension dimension, const Line& header) {
    try {
        return parse_quantity("1 " + std::string(unit), dimension);
    } catch (const QuantityError& error) {
        fail(header.place, "", error.rule, header_remedy);
    }
}

// From the table's unit to rad/s. "1/s" is used for both and says neither.
double frequency_factor(std::string_view unit, const Line& header) {
    if (unit.find("Hz") != std::string_view::npos || unit.find("hertz") != std::string_view::npos)
        return 2 * std::numbers::pi * factor_of(unit, Dimension::frequency, header);
    try {
        return parse_quantity("1 " + std::string(unit), Dimension::angular_frequency);
    } catch (const QuantityError&) {
        fail(header.place, "",
             toml_string(shortened(unit, 40)) + " is neither a frequency in Hz nor one in rad/s",
             header_remedy);
    }
}

double number_in(std::string_view cell, std::string_view name, const Line& line) {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const std::string subject = std::string(name) + " = " + shortened(cell, 40);
    if (error != std::errc() || end != cell.data() + cell.size())
        fail(line.place, subject, "must be a number", "write for example 0.21, with a point");
    if (!(value > 0) || !std::isfinite(value))
        fail(line.place, subject, "must be positive and finite", "correct or remove the row");
    return value;
}

}  // namespace

contact::DmaTable parse_dma_table(std::string_view text, const std::string& name) {
    const std::vector<Line> lines = lines_of(text, name);
    if (lines.empty()) fail(name, "", "the table is empty", header_remedy);
    if (lines.size() > most_rows + 1)
        fail(name, "", "has more than " + std::to_string(most_rows) + " rows", "thin it out");
    const char divider = divider_of(lines[0].text);
    const Cells header = cells_of(lines[0], divider);
    const double to_omega = frequency_factor(unit_in(header[0], names[0], lines[0]), lines[0]);
    std::array<double, 2> to_pascal{};
    for (std::size_t j = 0; j < 2; ++j)
        to_pascal[j] = factor_of(unit_in(header[j + 1], names[j + 1], lines[0]),
                                 Dimension::pressure, lines[0]);

    contact::DmaTable table{.name = name, .omega = {}, .storage = {}, .loss = {}};
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const Cells cells = cells_of(lines[k], divider);
        table.omega.push_back(to_omega * number_in(cells[0], names[0], lines[k]));
        table.storage.push_back(to_pascal[0] * number_in(cells[1], names[1], lines[k]));
        table.loss.push_back(to_pascal[1] * number_in(cells[2], names[2], lines[k]));
        if (k > 1 && !(table.omega[k - 1] > table.omega[k - 2]))
            fail(lines[k].place, "frequency = " + std::string(cells[0]),
                 "frequencies must increase from row to row", "sort the table");
    }
    return table;
}

contact::DmaTable read_dma_table(const std::string& path) {
    return parse_dma_table(read_input_file(path, "DMA table"),
                           std::filesystem::path(path).filename().string());
}

}  // namespace tricontact::io
