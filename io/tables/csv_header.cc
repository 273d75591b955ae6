#include "io/tables/csv_header.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "io/keys/messages.h"
#include "io/keys/units.h"
#include "io/tables/divided_text.h"

namespace tricontact::io {

namespace {

using Cells = std::vector<std::string_view>;

/// Whether it has the form of a number, whatever marks its decimals.
bool looks_like_number(std::string_view cell) {
    DecimalReader any("");
    return any.number(cell, 0).has_value();
}

struct Line {
    char divider = ',';
    std::size_t n_cells = 0, n_numbers = 0, n_empty = 0;
    bool is_row() const { return n_numbers > 0 && n_numbers + n_empty == n_cells; }
};

std::string place_in(const std::string& name, std::size_t number) {
    return name + ':' + std::to_string(number);
}

Line line_of(const TextLine& text, const std::string& name) {
    Line line{.divider = divider_of(text.text)};
    for (const auto cell : divided_cells(text.text, line.divider, place_in(name, text.number))) {
        ++line.n_cells;
        if (cell.empty()) ++line.n_empty;
        if (looks_like_number(cell)) ++line.n_numbers;
    }
    return line;
}

/// The first row that has as many cells as most rows have.
std::optional<std::size_t> first_row_of(const std::vector<Line>& lines) {
    std::map<std::size_t, std::size_t> counts;
    for (const Line& line : lines)
        if (line.is_row()) ++counts[line.n_cells];
    std::size_t n_cells = 0, most = 0;
    for (const auto& [n, count] : counts) {
        if (count < most) continue;
        n_cells = n;
        most = count;
    }
    const auto found = std::ranges::find_if(
        lines, [&](const Line& line) { return line.is_row() && line.n_cells == n_cells; });
    if (found == lines.end()) return {};
    return static_cast<std::size_t>(found - lines.begin());
}

std::string_view without_brackets(std::string_view cell) {
    const bool bracketed = cell.size() > 1 && ((cell.front() == '[' && cell.back() == ']') ||
                                               (cell.front() == '(' && cell.back() == ')'));
    return bracketed ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

bool is_unit(std::string_view text) {
    for (int k = 1; k <= static_cast<int>(Dimension::pressure_per_length); ++k) try {
            parse_quantity("1 " + std::string(text), static_cast<Dimension>(k));
            return true;
        } catch (const QuantityError&) {
            continue;
        }
    return false;
}

/// Of units alone, but for columns that have none here.
bool are_units(const Cells& cells) {
    constexpr std::array<std::string_view, 8> others{"",  "-", "%",    "V",
                                                     "K", "C", "degC", "\u00b0C"};
    bool some = false;
    for (const auto cell : cells) {
        const auto text = without_brackets(cell);
        if (std::ranges::count(others, text) > 0) continue;
        if (!is_unit(text)) return false;
        some = true;
    }
    return some;
}

bool has_brackets(const Cells& cells) {
    return std::ranges::any_of(cells, [](std::string_view cell) {
        return cell.size() > 1 && (cell.ends_with(']') || cell.ends_with(')')) && cell != "[]" &&
               without_brackets(cell) == cell;
    });
}

std::vector<std::string> texts_of(const Cells& cells) {
    return {cells.begin(), cells.end()};
}

bool has_numbers(const Cells& cells) {
    return std::ranges::any_of(cells, looks_like_number);
}

/// A comment that names as many columns: NumPy's savetxt writes such headers.
std::optional<CsvHeader> header_in_comments(const CsvLines& text, const Line& row,
                                            const std::string& name) {
    for (auto comment = text.comments.rbegin(); comment != text.comments.rend(); ++comment) {
        const auto begin = comment->text.find_first_not_of("# ");
        if (begin == std::string_view::npos) continue;
        const auto line = comment->text.substr(begin);
        const std::string place = place_in(name, comment->number);
        const Cells cells = heading_cells(line, row.divider, place);
        if (cells.size() == row.n_cells && !has_numbers(cells))
            return CsvHeader{comment->number, texts_of(cells), {}, 0, row.divider};
    }
    return {};
}

}  // namespace

CsvLines csv_lines(std::string_view text, std::size_t most) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";  // of UTF-8
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    CsvLines found;
    for (std::size_t number = 1; !text.empty() && found.lines.size() < most; ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (trimmed(line).empty()) continue;
        line.remove_prefix(std::min(line.find_first_not_of(" \r"), line.size()));
        line = line.substr(0, line.find_last_not_of(" \r") + 1);
        const bool comment = trimmed(line).front() == '#';
        if (!comment)
            found.lines.push_back({number, line});
        else if (found.lines.empty() && found.comments.size() < most_preamble_lines)
            found.comments.push_back({number, line});
    }
    return found;
}

std::vector<std::string_view> heading_cells(std::string_view line, char divider,
                                            const std::string& place) {
    const Cells cells = divided_cells(line, divider, place);
    if (divider != ' ') return cells;
    Cells joined;
    for (const auto cell : cells) {
        if (!joined.empty() && (cell.starts_with('[') || cell.starts_with('(')) &&
            joined.back().data() + joined.back().size() < cell.data()) {
            const char* const begin = joined.back().data();
            joined.back() = {begin, static_cast<std::size_t>(cell.data() + cell.size() - begin)};
        } else {
            joined.push_back(cell);
        }
    }
    return joined;
}

CsvHeader find_header(const CsvLines& text, const std::string& name) {
    const auto& lines = text.lines;
    std::vector<Line> looked;
    for (const TextLine& line : lines) {
        if (looked.size() > 2 * most_preamble_lines) break;
        looked.push_back(line_of(line, name));
    }
    const auto headings = [&](std::size_t i, char divider) {
        return heading_cells(lines[i].text, divider, place_in(name, lines[i].number));
    };
    const auto header_at = [&](std::size_t i, char divider) {
        return CsvHeader{lines[i].number, texts_of(headings(i, divider)), {}, i + 1, divider};
    };
    const auto row = first_row_of(looked);
    if (!row) return header_at(0, looked[0].divider);
    const Line& numbers = looked[*row];
    if (*row == 0) {
        const auto comment = header_in_comments(text, numbers, name);
        return comment ? *comment : header_at(0, numbers.divider);
    }
    // Lines of names right above the first row, as many as its cells.
    std::size_t first = *row;
    const auto names = [&](std::size_t i) {
        const Cells cells = headings(i, numbers.divider);
        // R's write.table has no name for the numbers of its rows.
        const bool fits = cells.size() == numbers.n_cells || cells.size() + 1 == numbers.n_cells;
        return fits && !has_numbers(cells);
    };
    while (first > 0 && names(first - 1)) --first;
    if (first == *row) return header_at(0, numbers.divider);
    std::size_t header = *row - 1;
    for (std::size_t i = first; i < *row; ++i)
        if (has_brackets(headings(i, numbers.divider))) {
            header = i;
            break;
        }
    const Cells last = headings(*row - 1, numbers.divider);
    if (*row - first < 2 || header + 1 < *row || !are_units(last))
        return header_at(header, numbers.divider);
    CsvHeader found = header_at(*row - 2, numbers.divider);
    for (const auto cell : last) found.units.emplace_back(without_brackets(cell));
    found.first_row = *row;
    return found;
}

}  // namespace tricontact::io
