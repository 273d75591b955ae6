#include "contact/base/plain_text.h"

namespace tricontact::contact {

namespace {

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// Length of the character in UTF-8 that the text begins with; 1 of a byte that begins none.
std::size_t length_of_first(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t n = lead >= 0xF0 && lead < 0xF5   ? 4
                          : lead >= 0xE0 && lead < 0xF0 ? 3
                          : lead >= 0xC2 && lead < 0xE0 ? 2
                                                        : 1;
    for (std::size_t i = 1; i < n; ++i)
        if (i >= text.size() || !continues(text[i])) return 1;
    return n;
}

/// Of one character in UTF-8, or a byte that is none.
bool acts(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1) return byte(0) < 0x20 || (byte(0) >= 0x7F && byte(0) < 0xA0);
    if (character.size() == 2)  // C1; the mark of Arabic letters, U+061C
        return (byte(0) == 0xC2 && byte(1) < 0xA0) || character == "\xD8\x9C";
    if (!character.starts_with("\xE2")) return false;
    const unsigned char last = byte(character.size() - 1);
    if (byte(1) == 0x80)  // U+200E, U+200F; U+2028 to U+202E
        return last == 0x8E || last == 0x8F || (last >= 0xA8 && last <= 0xAE);
    return byte(1) == 0x81 && last >= 0xA6 && last <= 0xA9;  // U+2066 to U+2069
}

}  // namespace

std::string plain_text(std::string_view text, std::string_view kept) {
    std::string plain;
    plain.reserve(text.size());
    while (!text.empty()) {
        const std::string_view first = text.substr(0, length_of_first(text));
        if (acts(first) && kept.find(first) == kept.npos)
            plain += ' ';
        else
            plain += first;
        text.remove_prefix(first.size());
    }
    return plain;
}

}  // namespace tricontact::contact
