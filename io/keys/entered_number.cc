#include "io/keys/entered_number.h"

#include <algorithm>
#include <cmath>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
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
    for (; line > 1; --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    text = text.substr(0, text.find_first_of("\n#"));
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
        if (text[i] == '.' && is_digit(text[i + 1]) &&
            std::string_view(" \t=[,+-").find(text[i - 1]) != std::string_view::npos)
            return true;
    return false;
}

}  // namespace tricontact::io
