#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tricontact::report {

/// RFC 4180: quotes around what holds commas, quotes or line ends; quotes doubled. A text that a
/// spreadsheet would compute (it begins with = + - @ or a tab and is no number), or that begins
/// with an apostrophe, has an apostrophe before it: without that one it is the text again.
std::string csv_field(const std::string& text);

/// The shortest number that reads back the same; nothing where undefined or infinite.
std::string csv_field(double value);
std::string csv_field(const std::optional<double>& value);

/// Fields with commas between them and a line end.
std::string csv_line(const std::vector<std::string>& fields);

/// The line of these values.
template <class... Values>
std::string csv_row(const Values&... values) {
    return csv_line({csv_field(values)...});
}

}  // namespace tricontact::report
