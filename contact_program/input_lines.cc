#include "contact_program/input_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::contact_program {

namespace {

constexpr std::size_t longest_in_message = 40;

std::string quoted(std::string_view word) {
    if (io::first_non_utf8(word) != std::string_view::npos) return "what stands there";
    return fmt::format("\"{}\"", io::one_line(io::shortened(word, longest_in_message)));
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Fortran writes exponents as 1.5e-3, 1.5d-3, or by their sign alone, 1.5-3.
std::optional<double> fortran_number(std::string_view word) {
    std::string text(word);
    std::ranges::replace_if(
        text, [](char c) { return c == 'd' || c == 'D' || c == 'E'; }, 'e');
    const std::size_t sign = text.find_last_of("+-");
    if (sign != std::string::npos && sign > 0 &&
        (is_digit(text[sign - 1]) || text[sign - 1] == '.'))
        text.insert(sign, 1, 'e');
    const auto value = io::number_in(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

bool InputLines::advance() {
    while (at_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        current_ = std::string_view(text_).substr(at_, end - at_);
        at_ = end + 1;
        ++line_;
        words_ = io::words_of(current_.substr(0, current_.find('%')), " \t\r,=");
        next_ = 0;
        if (!words_.empty()) return true;
    }
    words_.clear();
    next_ = 0;
    return false;
}

bool InputLines::at_end() {
    return next_ == words_.size() && !advance();
}

std::string_view InputLines::next_word(std::string_view what) {
    if (at_end())
        io::fail(fmt::format("{}:{}", name_, line_), "",
                 fmt::format("the file ends, but {} due", what),
                 "complete it, or end it by \"0 MODULE\"");
    const std::string_view word = words_[next_++];
    column_ = static_cast<int>(word.data() - current_.data()) + 1;
    return word;
}

InputNumber InputLines::next_number(std::string_view what) {
    const std::string_view word = next_word(fmt::format("{} are", what));
    const auto value = fortran_number(word);
    if (!value)
        refuse(quoted(word), fmt::format("is no number, but {} are due", what), "correct it");
    return {*value, line_, column_};
}

std::vector<InputNumber> InputLines::numbers(std::size_t n, std::string_view what,
                                             std::size_t further) {
    std::vector<InputNumber> values;
    while (values.size() < n) values.push_back(next_number(what));
    while (values.size() < n + further && next_ < words_.size() && fortran_number(words_[next_]))
        values.push_back(next_number(what));
    end_of_values();
    return values;
}

void InputLines::skip_numbers(std::size_t n, std::string_view what) {
    for (std::size_t k = 0; k < n; ++k) next_number(what);
    end_of_values();
}

std::vector<InputNumber> InputLines::angle_and_numbers(std::size_t n, std::string_view what,
                                                       std::size_t further) {
    std::string_view word = next_word(fmt::format("{} are", what));
    const bool degrees = word.ends_with('d') || word.ends_with('D');
    const auto angle = fortran_number(degrees ? word.substr(0, word.size() - 1) : word);
    if (!angle)
        refuse(quoted(word), fmt::format("is no angle, but {} are due", what),
               "give it in radians, or in degrees as 90d");
    std::vector<InputNumber> values{
        {*angle * (degrees ? std::numbers::pi / 180 : 1), line_, column_}};
    for (const InputNumber& value : numbers(n - 1, what, further)) values.push_back(value);
    return values;
}

std::string InputLines::text(std::string_view what) {
    const std::string_view word = next_word(fmt::format("{} is", what));
    end_of_values();
    if (word.front() != '\'') return std::string(word);
    const std::size_t begin = word.data() - current_.data() + 1, end = current_.find('\'', begin);
    if (end == std::string_view::npos)
        refuse(quoted(word), "has no apostrophe at its end", "add it");
    return std::string(current_.substr(begin, end - begin));
}

int InputLines::whole_number(std::string_view what) {
    const std::string_view word = next_word(fmt::format("{} is", what));
    const std::string_view number = io::without_plus(word);
    int value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size())
        refuse(quoted(word), fmt::format("is no whole number, but {} is due", what), "correct it");
    end_of_values();
    return value;
}

std::vector<int> InputLines::digits(std::size_t n, std::string_view what) {
    const std::string_view word = next_word(fmt::format("{} are", what));
    const bool all = std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
    if (!all || word.size() > n)
        refuse(quoted(word), fmt::format("are not the digits {}", what), "correct them");
    end_of_values();
    std::vector<int> values(n - word.size(), 0);
    for (const char c : word) values.push_back(c - '0');
    return values;
}

std::string InputLines::place(int line, int column) const {
    return fmt::format("{}:{}:{}", name_, line, column);
}

void InputLines::refuse(std::string_view subject, std::string_view rule,
                        std::string_view remedy) const {
    io::fail(place(line_, column_), subject, rule, remedy);
}

void InputLines::refuse(std::string_view name, const InputNumber& number, std::string_view rule,
                        std::string_view remedy) const {
    io::fail(place(number.line, number.column), fmt::format("{} = {}", name, number.value), rule,
             remedy);
}

void InputLines::refuse_line(int line, std::string_view subject, std::string_view rule,
                             std::string_view remedy) const {
    io::fail(place(line, 1), subject, rule, remedy);
}

void refuse_at(const std::string& name, int line, const std::string& subject, std::string_view rule,
               std::string_view remedy) {
    io::fail(fmt::format("{}:{}:1", name, line), subject, rule, remedy);
}

}  // namespace tricontact::contact_program
