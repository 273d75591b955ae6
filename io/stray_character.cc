#include "io/stray_character.h"

#include <algorithm>

namespace tricontact::io {

namespace {

constexpr auto npos = std::string_view::npos;

bool is_ascii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

// Offset of the first byte that is not white space.
std::size_t skip_space(std::string_view text, std::size_t i) {
    return std::min(text.find_first_not_of(" \t\r\n", i), text.size());
}

// Length of the run of `quote` at `i`.
std::size_t count_quotes(std::string_view text, std::size_t i, char quote) {
    return std::min(text.find_first_not_of(quote, i), text.size()) - i;
}

// Offset behind the string that begins at `i`, or of a stray character in it. The end of the text
// if the string does not end: no TOML from there on.
std::size_t end_of_string(std::string_view text, std::size_t i) {
    const char quote = text[i];
    const bool multiline = count_quotes(text, i, quote) >= 3;
    for (i += multiline ? 3 : 1; i < text.size(); ++i) {
        if (quote == '"' && text[i] == '\\') {
            // toml++ looks for white space behind a backslash, too.
            const std::size_t next = multiline ? skip_space(text, i + 1) : text.size();
            if (next < text.size() && !is_ascii(text[next])) return next;
            ++i;
        } else if (!multiline && text[i] == '\n') {
            return text.size();
        } else if (!multiline && text[i] == quote) {
            return i + 1;
        } else if (multiline && count_quotes(text, i, quote) >= 3) {
            // Up to two quotes in front of the closing three belong to the text.
            return i + std::min<std::size_t>(count_quotes(text, i, quote), 5);
        }
    }
    return text.size();
}

// Strings begin after a delimiter. A quote glued to a word is no TOML, and toml++ looks ahead
// through it for the end of the word.
bool begins_string(std::string_view text, std::size_t i) {
    constexpr std::string_view quotes = "\"'", delimiters = " \t\r\n=,[{.";
    if (quotes.find(text[i]) == npos) return false;
    return i == 0 || delimiters.find(text[i - 1]) != npos;
}

}  // namespace

std::size_t stray_character(std::string_view toml) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    std::size_t i = toml.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    while (i < toml.size()) {
        if (!is_ascii(toml[i])) return i;
        if (toml[i] == '#')
            i = std::min(toml.find('\n', i), toml.size());
        else if (begins_string(toml, i))
            i = end_of_string(toml, i);
        else
            ++i;
    }
    return npos;
}

}  // namespace tricontact::io
