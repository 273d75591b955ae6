// Texts of inputs on a terminal.

#include "contact/base/plain_text.h"

#include <gtest/gtest.h>

namespace tricontact::contact::plain_text_test {
namespace {

std::string utf8(char32_t c) {
    const auto byte = [](char32_t value) { return static_cast<char>(value); };
    if (c < 0x80) return {byte(c)};
    if (c < 0x800) return {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
    if (c < 0x10000)
        return {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
    return {byte(0xF0 | c >> 18), byte(0x80 | (c >> 12 & 0x3F)), byte(0x80 | (c >> 6 & 0x3F)),
            byte(0x80 | (c & 0x3F))};
}

// Unicode 15: general category Cc, the property Bidi_Control, and the separators Zl and Zp.
bool acts(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x61C || c == 0x200E || c == 0x200F ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

TEST(PlainText, ReplacesWhatActsAndNothingElse) {
    for (char32_t c = 0; c < 0x11000; ++c) {
        if (c >= 0xD800 && c < 0xE000) continue;
        const std::string text = "a" + utf8(c) + "b";
        EXPECT_EQ(plain_text(text), acts(c) ? "a b" : text) << std::hex << static_cast<int>(c);
    }
    EXPECT_EQ(plain_text(utf8(0x1F600)), utf8(0x1F600));
}

TEST(PlainText, ReplacesBytesThatATerminalOfEightBitsActsOn) {
    for (int byte = 0x80; byte < 0x100; ++byte) {
        const std::string alone = std::string("a") + static_cast<char>(byte) + "b";
        EXPECT_EQ(plain_text(alone), byte < 0xA0 ? "a b" : alone) << byte;
    }
    EXPECT_EQ(plain_text("\xE2\x80"), "\xE2 ") << "cut off";
    EXPECT_EQ(plain_text("\xC2\xC2\x9B"), "\xC2 ");
}

TEST(PlainText, KeepsWhatItIsTold) {
    EXPECT_EQ(plain_text("a\tb\nc\x1b[31m", "\t\n"), "a\tb\nc [31m");
}

}  // namespace
}  // namespace tricontact::contact::plain_text_test
