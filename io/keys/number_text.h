#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Words of a line, divided by blanks and tabs, or other characters.
std::vector<std::string_view> words_of(std::string_view line, std::string_view blanks = " \t\r");

/// A line of a text that says something.
struct TextLine {
    std::size_t number = 0;  ///< from 1
    std::string_view text;   ///< without blanks at both ends
};
/// The parts of a line, without blanks at both ends.
std::vector<std::string_view> cells_of(std::string_view line, char divider);

/// Without a plus in front of a number, which std::from_chars refuses.
std::string_view without_plus(std::string_view word);

/// The whole word as a number, decimal point, sign allowed; empty if it is none.
std::optional<double> number_in(std::string_view word);

/// value * factor. Throws contact::InputError, naming the place, where that is no double: infinite,
/// or zero of a value that is not.
double scaled(double value, double factor, const std::string& place);

/// Source of the TOML value at this line and character, both from 1: up to the end of the line, of
/// a list up to its bracket.
std::string_view source_at(std::string_view text, std::size_t line, std::size_t column);

/// Whether a number in the source of a TOML value, or of a list of them, is smaller than the least
/// double, which parsers make zero of.
bool underflows(std::string_view source);

/// A number, or a list of numbers, as people type it, where TOML is stricter (".24", "5.", "+.5",
/// "007") or calls a whole number none ("1e4"). Empty for what else TOML has ("1_000", "inf").
std::optional<Value> entered_number(std::string_view text);

/// Whether this line (from 1 on) of a text has a number that begins with its point.
bool has_bare_point(std::string_view text, std::size_t line);

}  // namespace tricontact::io
