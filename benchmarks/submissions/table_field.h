#pragma once

#include <string>
#include <string_view>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Most points of a field.
inline constexpr std::size_t most_points = 2'000'000;
/// Largest file of results [MB].
inline constexpr std::size_t most_megabytes = 400;

/// A table of columns with the units in brackets, and of lines "# key = value unit" for what stands
/// beside the field. A comment is such a line where one word stands before the sign of equality (or
/// a known key before a colon); an unknown key is refused. Other comments are free. `text`: UTF-8.
/// Throws contact::InputError.
MeshField parse_table(std::string_view text, const std::string& name);

/// Lines "key = value unit" alone, with or without the mark of comments: a second file with
/// resultants. Throws contact::InputError.
std::map<std::string, Total> parse_totals(std::string_view text, const std::string& name);

}  // namespace tricontact::benchmarks
