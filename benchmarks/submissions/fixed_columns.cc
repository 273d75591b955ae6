#include "benchmarks/submissions/fixed_columns.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::benchmarks {

namespace {

bool is_digit_of(std::string_view text, std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
}

/// Length of the number at the beginning of the text.
std::size_t length_of_number(std::string_view text) {
    const auto is_sign = [&](std::size_t i) {
        return i < text.size() && (text[i] == '-' || text[i] == '+');
    };
    std::size_t i = is_sign(0) ? 1 : 0;
    while (is_digit_of(text, i) || (i < text.size() && text[i] == '.')) ++i;
    const bool has_letter = i < text.size() && std::string_view("eEdD").find(text[i]) != text.npos;
    if (has_letter) {
        ++i;
        if (is_sign(i)) ++i;
        while (is_digit_of(text, i)) ++i;
    } else if (is_sign(i) && is_digit_of(text, i + 1) && is_digit_of(text, i + 2) &&
               is_digit_of(text, i + 3) && !is_digit_of(text, i + 4) &&
               (i + 4 >= text.size() || text[i + 4] != '.')) {
        i += 4;  // an exponent of three digits has no letter
    }
    return i;
}

}  // namespace

std::optional<double> fortran_number(std::string_view field) {
    field = io::trimmed(field);
    if (field.empty() || field.size() > 40) return {};
    if (const auto value = io::number_in(field)) return value;
    std::string digits;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const char c = field[i];
        const bool is_letter = c == 'd' || c == 'D';
        const bool is_sign =
            (c == '-' || c == '+') && i > 0 && (is_digit_of(field, i - 1) || field[i - 1] == '.');
        if (is_sign) digits += 'e';
        digits += is_letter ? 'e' : c;
    }
    return io::number_in(digits);
}

std::vector<double> numbers_of_twelve(std::string_view line, std::size_t begin, std::size_t most) {
    constexpr std::size_t width = 12;
    std::vector<double> values;
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    for (std::size_t at = begin; values.size() < most && at < line.size(); at += width) {
        const auto value = fortran_number(line.substr(at, width));
        if (!value) break;
        values.push_back(*value);
    }
    if (line.size() <= begin + width * values.size()) return values;
    // Numbers of more than twelve characters move those behind.
    std::vector<double> one_by_one;
    for (std::size_t at = begin; one_by_one.size() < most;) {
        at = line.find_first_not_of(' ', at);
        if (at == line.npos) break;
        const std::size_t length = length_of_number(line.substr(at));
        const auto value = fortran_number(line.substr(at, length));
        if (!value) break;
        one_by_one.push_back(*value);
        at += length;
    }
    return one_by_one.size() > values.size() ? one_by_one : values;
}

std::optional<int> whole_number(std::string_view line, std::size_t begin, std::size_t width) {
    if (begin >= line.size()) return {};
    const std::string_view field = io::trimmed(line.substr(begin, width));
    int value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (field.empty() || error != std::errc() || end != field.data() + field.size()) return {};
    return value;
}

bool LineReader::next() {
    if (rest_.empty()) return false;
    const auto end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
}

}  // namespace tricontact::benchmarks
