#include "io/contact_program/input_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

constexpr std::size_t longest_in_message = 40;

std::string quoted(std::string_view word) {
    return fmt::format("\"{}\"", one_line(shortened(word, longest_in_message)));
}

/// Fortran writes the exponent of double precision as 1.5d-3.
std::optional<double> fortran_number(std::string_view word) {
    std::string text(word);
    std::ranges::replace_if(
        text, [](char c) { return c == 'd' || c == 'D'; }, 'e');
    const auto value = number_in(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// A digit, what it may be, why not something else, and its place among those that are read.
struct Digit {
    char letter;
    std::string_view allowed, rule, remedy;
    int CaseDigits::*place = nullptr;
};

constexpr std::string_view any = "0123456789";

const std::vector<Digit> first_word = {
    {'P', "02", "a case goes on from the one before or begins again", "give 0 or 2",
     &CaseDigits::previous},
    {'B', "0", "only the full normal problem is solved", "give 0"},
    {'T', "01", "only shifts in world-fixed coordinates are cases here",
     "give 0 or 1; what rolls on is computed by tricontact roll", &CaseDigits::tangential},
    {'N', "01", "depth or normal force is prescribed", "give 0 or 1", &CaseDigits::normal},
    {'F', "012", "shifts or forces are prescribed", "give 0, 1 or 2", &CaseDigits::force},
    {'S', "0", "stresses inside are asked for by output.volume of the case", "give 0"},
};
const std::vector<Digit> second_word = {
    {'V', "0", "friction is the same everywhere", "give 0"},
    {'L', "01", "only Coulomb friction is a case here", "give 0, or 1 to keep it",
     &CaseDigits::friction},
    {'D', "02", "cells are new or kept", "give 0 or 2", &CaseDigits::cells},
    {'C', "02",
     "only half-spaces with constant tractions per cell are read; coefficients of a "
     "file do not tell the layer",
     "give 0 or 2", &CaseDigits::influence},
    {'M', "0", "only elastic bodies are cases here", "give 0"},
    {'Z', "02", "undeformed distances are new or kept", "give 0 or 2", &CaseDigits::distance},
    {'E', "0", "no further term of slip is a case here", "give 0"},
};
const std::vector<Digit> third_word = {
    {'X', "0", "debug output has lines of its own", "give 0"},
    {'H', "0", "no temperatures are computed", "give 0"},
    {'G', "01", "settings of other solvers have no counterpart", "give 0 or 1",
     &CaseDigits::solver},
    {'I', any, "", ""},
    {'A', any, "", ""},
    {'O', any, "", ""},
    {'W', any, "", ""},
    {'R', "01", "every case is computed", "give 0 or 1", &CaseDigits::after},
};

void read_word(InputLines& lines, const std::vector<Digit>& declared, CaseDigits& digits) {
    std::string letters;
    for (const Digit& digit : declared) letters += digit.letter;
    const std::vector<int> values = lines.digits(declared.size(), letters);
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Digit& digit = declared[k];
        if (digit.allowed.find(static_cast<char>('0' + values[k])) == std::string_view::npos)
            lines.refuse(fmt::format("{} = {}", digit.letter, values[k]), digit.rule, digit.remedy);
        if (digit.place) digits.*digit.place = values[k];
    }
}

}  // namespace

bool InputLines::advance() {
    while (at_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        current_ = std::string_view(text_).substr(at_, end - at_);
        at_ = end + 1;
        ++line_;
        words_ = words_of(current_.substr(0, current_.find('%')), " \t\r,=");
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
        fail(fmt::format("{}:{}", name_, line_), "", fmt::format("the file ends, but {} due", what),
             "complete it, or end it by \"0 MODULE\"");
    const std::string_view word = words_[next_++];
    column_ = static_cast<int>(word.data() - current_.data()) + 1;
    return word;
}

std::vector<InputNumber> InputLines::numbers(std::size_t n, std::string_view what) {
    std::vector<InputNumber> values;
    while (values.size() < n) {
        const std::string_view word = next_word(fmt::format("{} are", what));
        const auto value = fortran_number(word);
        if (!value)
            refuse(quoted(word), fmt::format("is no number, but {} are due", what), "correct it");
        values.push_back({*value, line_, column_});
    }
    end_of_values();
    return values;
}

int InputLines::whole_number(std::string_view what) {
    const std::string_view word = next_word(fmt::format("{} is", what));
    const std::string_view number = without_plus(word);
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
    fail(place(line_, column_), subject, rule, remedy);
}

void InputLines::refuse(std::string_view name, const InputNumber& number, std::string_view rule,
                        std::string_view remedy) const {
    fail(place(number.line, number.column), fmt::format("{} = {}", name, number.value), rule,
         remedy);
}

void InputLines::refuse_line(int line, std::string_view subject, std::string_view rule,
                             std::string_view remedy) const {
    fail(place(line, 1), subject, rule, remedy);
}

CaseDigits read_digits(InputLines& lines) {
    CaseDigits digits;
    read_word(lines, first_word, digits);
    digits.line = lines.line();
    read_word(lines, second_word, digits);
    read_word(lines, third_word, digits);
    return digits;
}

}  // namespace tricontact::io
