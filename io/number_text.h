#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Words of a line, divided by blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line);

/// Without a plus in front of a number, which std::from_chars refuses.
std::string_view without_plus(std::string_view word);

/// The whole word as a number, decimal point, sign allowed; empty if it is none.
std::optional<double> number_in(std::string_view word);

}  // namespace tricontact::io
