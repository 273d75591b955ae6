#include "io/keys/toml_text.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace tricontact::io {

namespace {

constexpr std::size_t capacity = 65000;  // plane 15 holds 65534 private-use characters

// Bytes of the UTF-8 character that begins with this byte.
std::size_t length_of(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

// U+F0000 + k in UTF-8: F3 B0 80 80 and on, six bits in each of the last two bytes.
std::string private_character(std::size_t k) {
    return {'\xF3', static_cast<char>(0xB0 + (k >> 12)), static_cast<char>(0x80 + (k >> 6 & 0x3F)),
            static_cast<char>(0x80 + (k & 0x3F))};
}

// The k of a private character, `capacity` for any other.
std::size_t index_of(std::string_view character) {
    const auto bits = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(character[i]));
    };
    if (character.size() != 4 || character[0] != '\xF3' || bits(1) < 0xB0) return capacity;
    return (bits(1) - 0xB0) << 12 | (bits(2) & 0x3F) << 6 | (bits(3) & 0x3F);
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

std::string NonAsciiEscaper::escaped(std::string_view text) {
    std::unordered_map<std::string, std::size_t> known;
    for (std::size_t k = 0; k < characters_.size(); ++k) known.emplace(characters_[k], k);
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    std::size_t i = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    std::string out(text.substr(0, i));
    for (std::size_t length = 0; i < text.size(); i += length) {
        length = length_of(text[i]);
        if (length == 1) {
            out += text[i];
            continue;
        }
        const std::string character(text.substr(i, length));
        const auto [it, added] = known.emplace(character, characters_.size());
        if (added) characters_.push_back(character);
        if (characters_.size() > capacity)
            throw std::length_error("too many different characters beyond ASCII");
        out += private_character(it->second);
    }
    return out;
}

std::string NonAsciiEscaper::restored(std::string_view text) const {
    std::string out;
    for (std::size_t i = 0, length = 0; i < text.size(); i += length) {
        length = std::min(length_of(text[i]), text.size() - i);
        const std::size_t k = index_of(text.substr(i, length));
        if (k < characters_.size())
            out += characters_[k];
        else
            out += text.substr(i, length);
    }
    return out;
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
