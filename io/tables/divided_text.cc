#include "io/tables/divided_text.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

const std::string text_remedy = "save it as text in UTF-8";

void append_utf8(char32_t c, std::string& out) {
    const auto tail = [&](int shift) { out += static_cast<char>(0x80 | ((c >> shift) & 0x3F)); };
    if (c < 0x80) {
        out += static_cast<char>(c);
    } else if (c < 0x800) {
        out += static_cast<char>(0xC0 | (c >> 6));
        tail(0);
    } else if (c < 0x10000) {
        out += static_cast<char>(0xE0 | (c >> 12));
        tail(6);
        tail(0);
    } else {
        out += static_cast<char>(0xF0 | (c >> 18));
        tail(12);
        tail(6);
        tail(0);
    }
}

/// `bytes` behind the mark of the order.
std::string from_utf16(std::string_view bytes, bool little, const std::string& name) {
    const auto refuse = [&] { fail(name, "", "is no whole text in UTF-16", text_remedy); };
    if (bytes.size() % 2 != 0) refuse();
    const auto unit = [&](std::size_t i) -> char32_t {
        const auto first = static_cast<unsigned char>(bytes[i]),
                   second = static_cast<unsigned char>(bytes[i + 1]);
        return little ? first | second << 8 : first << 8 | second;
    };
    std::string out;
    out.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        char32_t c = unit(i);
        if (c >= 0xDC00 && c < 0xE000) refuse();
        if (c >= 0xD800 && c < 0xDC00) {
            i += 2;
            const char32_t low = i < bytes.size() ? unit(i) : 0;
            if (low < 0xDC00 || low >= 0xE000) refuse();
            c = 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00);
        }
        append_utf8(c, out);
    }
    return out;
}

std::string from_latin1(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) append_utf8(static_cast<unsigned char>(c), out);
    return out;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether a comma stands in some of these words, and in each as a decimal mark does: one, between
/// digits.
bool has_decimal_commas(const std::vector<std::string_view>& words) {
    bool found = false;
    for (const std::string_view word : words) {
        const auto at = word.find(',');
        if (at == word.npos) continue;
        const bool between = at > 0 && at + 1 < word.size() && is_digit(word[at - 1]) &&
                             is_digit(word[at + 1]) && word.find(',', at + 1) == word.npos;
        if (!between) return false;
        found = true;
    }
    return found;
}

/// A letter instead of each quoted text.
std::string unquoted(std::string_view line) {
    std::string out;
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (!quoted)
            out += c;
        if (c == '"' && quoted) out += 'q';
    }
    return out;
}

/// The cell that begins at `at`; `at` moves to the divider behind it, or to the end.
std::string_view cell_at(std::string_view line, std::size_t& at, char divider,
                         const std::string& place) {
    at = std::min(line.find_first_not_of(divider == '\t' ? " " : " \t", at), line.size());
    if (at < line.size() && line[at] == '"') {
        const std::size_t end = line.find('"', at + 1);
        if (end == line.npos)
            fail(place, toml_string(shortened(line.substr(at), 40)), "the quote does not end",
                 "close it in its line");
        const std::string_view cell = line.substr(at + 1, end - at - 1);
        at = std::min(line.find_first_not_of(divider == '\t' ? " \r" : " \t\r", end + 1),
                      line.size());
        if (divider != ' ' && at < line.size() && line[at] != divider)
            fail(place, toml_string(shortened(line.substr(end), 40)),
                 "something stands behind a quote", "put the divider of the cells there");
        return trimmed(cell);
    }
    const std::size_t end = std::min(
        divider == ' ' ? line.find_first_of(" \t", at) : line.find(divider, at), line.size());
    const std::string_view cell = trimmed(line.substr(at, end - at));
    at = end;
    return cell;
}

}  // namespace

std::string utf8_text(std::string bytes, const std::string& name) {
    const std::string_view text = bytes;
    if (text.starts_with("\xFF\xFE"))
        bytes = from_utf16(text.substr(2), true, name);
    else if (text.starts_with("\xFE\xFF"))
        bytes = from_utf16(text.substr(2), false, name);
    const auto zero = std::string_view(bytes).substr(0, 4096).find('\0');
    if (zero != std::string_view::npos)
        fail(name, "", "holds zero bytes: UTF-16 without its mark, or no text", text_remedy);
    const bool plain = std::ranges::all_of(bytes, [](char c) { return c >= 0; });
    if (!plain && first_non_utf8(bytes) != std::string_view::npos) bytes = from_latin1(bytes);
    if (bytes.find('\n') == bytes.npos) std::ranges::replace(bytes, '\r', '\n');
    return bytes;
}

char divider_of(std::string_view line) {
    if (line.find('"') != line.npos) return divider_of(unquoted(line));
    if (line.find(';') != line.npos) return ';';
    const auto words = words_of(line, " \t\r");
    const bool commas = line.find(',') != line.npos;
    if (commas && !(words.size() > 1 && has_decimal_commas(words))) return ',';
    return line.find('\t') != line.npos ? '\t' : words.size() > 1 ? ' ' : ',';
}

std::vector<std::string_view> divided_cells(std::string_view line, char divider,
                                            const std::string& place) {
    if (line.find('"') == line.npos)
        return divider == ' ' ? words_of(line) : cells_of(line, divider);
    std::vector<std::string_view> cells;
    for (std::size_t at = 0;;) {
        cells.push_back(cell_at(line, at, divider, place));
        if (divider == ' ') at = line.find_first_not_of(" \t\r", at);
        if (at >= line.size()) return cells;
        if (divider != ' ') ++at;
    }
}

std::optional<double> DecimalReader::number(std::string_view cell, std::size_t line,
                                            bool& in_range) {
    in_range = true;
    const auto comma = cell.find(',');
    const char mark = comma != cell.npos ? ',' : cell.find('.') != cell.npos ? '.' : '\0';
    std::string_view word = without_plus(cell);
    if (mark == ',') {
        point_ = word;
        std::ranges::replace(point_, ',', '.');
        word = point_;
    }
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, value);
    if (word.empty() || at != end || error == std::errc::invalid_argument) return {};
    if (mark != '\0' && mark_ != '\0' && mark != mark_)
        fail(name_ + ':' + std::to_string(line), shortened(cell, 40),
             "the file has both decimal points and decimal commas",
             "write all numbers with points, without marks of thousands");
    if (mark != '\0') mark_ = mark;
    in_range = error != std::errc::result_out_of_range;
    return value;
}

}  // namespace tricontact::io
