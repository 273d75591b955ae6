#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/keys/number_text.h"

namespace tricontact::io {

/// The lines of a table: those that say something, and comments before the first of them.
struct CsvLines {
    std::vector<TextLine> lines, comments;
};
/// At most `most` lines. Tabs at their ends stay: they divide.
CsvLines csv_lines(std::string_view text, std::size_t most);

/// Names of columns without quotes; of words divided by blanks a unit in brackets belongs to the
/// word before. Throws contact::InputError, naming the place, at a quote that does not end.
std::vector<std::string_view> heading_cells(std::string_view line, char divider,
                                            const std::string& place);

/// Most lines that programs write before the names of the columns.
inline constexpr std::size_t most_preamble_lines = 100;

/// What names the columns of a table.
struct CsvHeader {
    std::size_t line_number = 1;        ///< in the file
    std::vector<std::string> headings;  ///< without quotes; empty ones too
    std::vector<std::string> units;     ///< of a row of units below; empty: there is none
    std::size_t first_row = 0;          ///< index of the first row below in `lines`
    char divider = ',';
};
/// The names are the last line without a number above the first row of numbers, or the last comment
/// above; a line of units may stand between names and rows. What stands above is a preamble. Where
/// no row has numbers, the first line. `name`: for messages. There must be a line.
CsvHeader find_header(const CsvLines& text, const std::string& name);

}  // namespace tricontact::io
