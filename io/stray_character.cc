#include "io/stray_character.h"

#include <algorithm>

namespace tricontact::io {

namespace {

constexpr auto npos = std::string_view::npos;

// Offset behind the string that begins at `i`, npos if it does not end: no TOML from there on.
std::size_t end_of_string(std::string_view text, std::size_t i) {
    const char quote = text[i];
    const bool escapes = quote == '"';
    const auto count = [&](std::size_t at) {  // of quotes in a row
        const auto rest = text.substr(std::min(at, text.size()));
        return std::min(rest.find_first_not_of(quote), rest.size());
    };
    const bool multiline = count(i) >= 3;
    for (i += multiline ? 3 : 1; i < text.size(); ++i) {
        if (escapes && text[i] == '\\')
            ++i;
        else if (!multiline && text[i] == '\n')
            return npos;
        else if (!multiline && text[i] == quote)
            return i + 1;
        else if (multiline && count(i) >= 3)
            return i + std::min<std::size_t>(count(i), 5);  // up to two quotes belong to the text
    }
    return npos;
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
        if (static_cast<unsigned char>(toml[i]) >= 0x80) return i;
        if (toml[i] == '#')
            i = toml.find('\n', i);
        else if (begins_string(toml, i))
            i = end_of_string(toml, i);
        else
            ++i;
    }
    return npos;
}

}  // namespace tricontact::io
