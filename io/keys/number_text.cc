#include "io/keys/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

// From the beginning of this line on, from 1.
std::string_view from_line(std::string_view text, std::size_t line) {
    for (; line > 1 && !text.empty(); --line)
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text;
}

std::optional<Value> single(std::string_view text) {
    constexpr double largest_whole = 9007199254740992.;  // 2^53: beyond, doubles have gaps
    if (text.find_first_not_of("+-.0123456789eE") != std::string_view::npos) return {};
    const auto number = number_in(text);
    if (!number) return {};
    const bool whole = text.find('.') == std::string_view::npos && *number == std::floor(*number) &&
                       std::abs(*number) < largest_whole;
    return whole ? Value(static_cast<std::int64_t>(*number)) : Value(*number);
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view line, std::string_view blanks) {
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(blanks, end);
    }
    return words;
}

std::vector<std::string_view> cells_of(std::string_view line, char divider) {
    std::vector<std::string_view> cells;
    for (;;) {
        const auto end = line.find(divider);
        cells.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return cells;
        line.remove_prefix(end + 1);
    }
}

std::string_view without_plus(std::string_view word) {
    const bool more = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return more ? word.substr(1) : word;
}

std::optional<double> number_in(std::string_view word) {
    word = without_plus(word);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size()) return {};
    return value;
}

double scaled(double value, double factor, const std::string& place) {
    const double result = value * factor;
    if (!std::isfinite(result) || (result == 0 && value != 0))
        fail(place, shortest(value), "leaves the range of double precision in its unit",
             "correct the number or the unit");
    return result;
}

std::string_view source_at(std::string_view text, std::size_t line, std::size_t column) {
    text = from_line(text, line);
    const auto continues = [](unsigned char c) { return (c & 0xC0) == 0x80; };
    for (; column > 1 && !text.empty(); --column) do
            text.remove_prefix(1);
        while (!text.empty() && continues(text.front()));
    return text.substr(0, text.find_first_of(text.starts_with('[') ? "]" : "\r\n,}#"));
}

bool underflows(std::string_view source) {
    constexpr std::string_view signs = "+-";
    for (std::size_t at = 0; at < source.size();) {
        const bool comment = source[at] == '#';
        const std::size_t end =
            std::min(comment ? source.find('\n', at) : source.find_first_of(" \t\r\n,[]{}#", at),
                     source.size());
        std::string word(source.substr(at, end - at));
        std::erase(word, '_');
        at = end + (source[std::min(end, source.size() - 1)] != '#' || comment);
        const std::size_t sign = !word.empty() && signs.find(word[0]) != signs.npos ? 1 : 0;
        double value = 1;
        const char* const last = word.data() + word.size();
        const auto [after, error] = std::from_chars(word.data() + sign, last, value);
        const std::string_view mantissa =
            std::string_view(word).substr(0, word.find_first_of("eE"));
        if (!comment && error == std::errc::result_out_of_range && after == last &&
            mantissa.find_first_of("123456789") != mantissa.npos)
            return true;
    }
    return false;
}

std::optional<Value> entered_number(std::string_view text) {
    if (!text.starts_with('[') || !text.ends_with(']')) return single(text);
    text = text.substr(1, text.size() - 2);
    std::vector<double> numbers;
    while (!trimmed(text).empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        const auto number = number_in(trimmed(text.substr(0, end)));
        if (!number || !std::isfinite(*number)) return {};
        numbers.push_back(*number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (numbers.empty()) return {};
    return numbers;
}

bool has_bare_point(std::string_view text, std::size_t line) {
    text = from_line(text, line);
    text = text.substr(0, text.find_first_of("\n#"));
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
        if (text[i] == '.' && std::string_view("0123456789").find(text[i + 1]) != text.npos &&
            std::string_view(" \t=[,+-").find(text[i - 1]) != std::string_view::npos)
            return true;
    return false;
}

}  // namespace tricontact::io
