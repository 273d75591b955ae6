#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/keys/number_text.h"

// Lines of numbers as instruments and programs write them: encodings, dividers, quotes, decimal
// commas.
namespace tricontact::io {

/// The bytes of a text file as UTF-8 with lines ended by \n: UTF-16 is known by its mark; what is
/// not UTF-8 is taken as ISO 8859-1, whose signs are those of units. Throws contact::InputError at
/// zero bytes, which no such text has.
std::string utf8_text(std::string bytes, const std::string& name);

/// What divides the cells of a line: ";", a tab, "," or " ". A comma within a number, "1,5 2,5", is
/// its decimal mark where something else divides.
char divider_of(std::string_view line);

/// The cells of a line without blanks at both ends and without quotes around them: within quotes
/// nothing divides. Of blanks any number is one divider. Throws contact::InputError, naming the
/// place, at a quote that does not end.
std::vector<std::string_view> divided_cells(std::string_view line, char divider,
                                            const std::string& place);

/// Reads numbers with a decimal point or a decimal comma: one of them in a whole file.
class DecimalReader {
  public:
    explicit DecimalReader(std::string name) : name_(std::move(name)) {}

    /// Empty if the cell is no number. A number beyond double precision is infinite or zero, as
    /// `in_range` tells. Throws contact::InputError where points and commas are mixed.
    std::optional<double> number(std::string_view cell, std::size_t line, bool& in_range);
    std::optional<double> number(std::string_view cell, std::size_t line) {
        bool in_range = true;
        const auto value = number(cell, line, in_range);
        return in_range ? value : std::nullopt;
    }

  private:
    std::string name_;
    char mark_ = 0;  // '.' or ',', once one was seen
    std::string point_;
};

}  // namespace tricontact::io
