#include "io/keys/toml_text.h"

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <iterator>

namespace tricontact::io {

namespace {

using boost::locale::utf::code_point;

constexpr code_point first_moved = 0x80, last_moved = 0xFEFF, plane_4 = 0x40000;

/// The characters from `first` to `last` moved by `shift`, modulo 2^32. What is no character stays.
std::string exchanged(std::string_view text, code_point first, code_point last, code_point shift) {
    using Utf8 = boost::locale::utf::utf_traits<char>;
    std::string out;
    for (auto at = text.begin(); at != text.end();) {
        const auto begin = at;
        const code_point character = Utf8::decode(at, text.end());
        if (character >= first && character <= last)
            Utf8::encode(character + shift, std::back_inserter(out));
        else
            out.append(begin, at);
    }
    return out;
}

constexpr int most_dots = 16;      // between two parts of a key; a number has one
constexpr int most_brackets = 32;  // open at once

/// Length of the string that the text begins with, its quotes included: up to its end, or that of
/// the line, or of the text.
std::size_t string_length(std::string_view text) {
    const char quote = text.front();
    const bool basic = quote == '"';
    const bool long_one = text.size() >= 3 && text[1] == quote && text[2] == quote;
    std::size_t i = long_one ? 3 : 1;
    for (; i < text.size(); ++i) {
        if (basic && text[i] == '\\') {
            ++i;
        } else if (!long_one && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        } else if (long_one && text.substr(i).starts_with(text.substr(0, 3))) {
            // Up to two quotes may stand before the three.
            std::size_t end = i + 3;
            while (end < text.size() && end < i + 5 && text[end] == quote) ++end;
            return end;
        }
    }
    return text.size();
}

}  // namespace

std::string escape_non_ascii(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    const std::size_t front = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    return std::string(text.substr(0, front)) +
           exchanged(text.substr(front), first_moved, last_moved, plane_4);
}

std::string restore_non_ascii(std::string_view text) {
    return exchanged(text, plane_4 + first_moved, plane_4 + last_moved, -plane_4);
}

std::size_t first_too_deep(std::string_view text) {
    constexpr std::string_view separators = "\n,=[]{}";
    int n_dots = 0, n_brackets = 0;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            i += string_length(text.substr(i));
            continue;
        }
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (c == '.') ++n_dots;
        if (separators.find(c) != separators.npos) n_dots = 0;
        if (c == '[' || c == '{') ++n_brackets;
        if ((c == ']' || c == '}') && n_brackets > 0) --n_brackets;
        if (n_dots > most_dots || n_brackets > most_brackets) return i;
        ++i;
    }
    return std::string_view::npos;
}

}  // namespace tricontact::io
