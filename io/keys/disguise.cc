#include "io/keys/disguise.h"

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

}  // namespace

std::string Disguise::put_on(std::string_view text) {
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

std::string Disguise::take_off(std::string_view text) const {
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

}  // namespace tricontact::io
