#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace tricontact::io {

/// TOML basic string with quotes; control characters are escaped.
std::string toml_string(std::string_view text);

/// Shortest digits that read back the same, as a TOML float ("22.0", "1e-07").
std::string toml_number(double value);

/// Shortest digits that read back the same.
std::string shortest(double value);

/// At most `limit` bytes of the text, cut at a character, and "..." if anything is left out.
std::string shortened(std::string_view text, std::size_t limit);

/// Without blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);

/// contact::plain_text of it: a message is one line whatever the input holds.
std::string one_line(std::string_view text);

/// Offset of the first byte that is not UTF-8, npos if all are (RFC 3629: shortest forms, no
/// surrogates, up to U+10FFFF).
std::string_view::size_type first_non_utf8(std::string_view text);

/// The candidate nearest to the word in edit distance (case ignored), empty if none is near.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// The texts of the elements, divided by commas.
template <class List, class TextOf = std::identity>
std::string joined(const List& list, const TextOf& text_of = {}) {
    std::string out;
    for (const auto& element : list) out.append(out.empty() ? "" : ", ").append(text_of(element));
    return out;
}

/// Throws contact::InputError `place: subject: rule; remedy` in one line; empty parts are left out.
[[noreturn]] void fail(std::string_view place, std::string_view subject, std::string_view rule,
                       std::string_view remedy);

}  // namespace tricontact::io
