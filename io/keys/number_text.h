#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Words of a line, divided by blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line);

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

}  // namespace tricontact::io
