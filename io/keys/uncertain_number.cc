#include "io/keys/uncertain_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

using statistics::Distribution;

constexpr std::array<std::string_view, 2> error_signs{"±", "+-"};
constexpr std::string_view percent_sign = "%";

[[noreturn]] void refuse_uncertain(const std::string& rule, Dimension dimension) {
    const bool pure = dimension == Dimension::none;
    throw QuantityError{rule,
                        "write " + std::string(name_of(dimension)) + " such as " +
                            toml_string(example_of(dimension)) + ", with an error \"1.55 ± 0.13" +
                            (pure ? "" : " " + std::string(si_unit(dimension))) + "\" or \"1.55" +
                            (pure ? "" : " " + std::string(si_unit(dimension))) + " ± 8 %\""};
}

// Takes "(uniform)" off the end of a text.
Distribution take_distribution(std::string_view& text, Dimension dimension) {
    text = trimmed(text);
    if (!text.ends_with(')')) return Distribution::normal;
    const auto open = text.rfind('(');
    if (open == text.npos) return Distribution::normal;
    const std::string_view word = trimmed(text.substr(open + 1, text.size() - open - 2));
    for (const auto one : {Distribution::normal, Distribution::uniform, Distribution::triangular})
        if (word == name_of(one)) {
            text = trimmed(text.substr(0, open));
            return one;
        }
    refuse_uncertain("(" + std::string(word) + ") is none of (normal), (uniform), (triangular)",
                     dimension);
}

// Value, and error if there is one.
struct Halves {
    std::string_view value;
    std::optional<std::string_view> error;
};

Halves halves_of(std::string_view text) {
    for (const std::string_view sign : error_signs)
        if (const auto at = text.find(sign); at != text.npos)
            return {trimmed(text.substr(0, at)), trimmed(text.substr(at + sign.size()))};
    return {trimmed(text), {}};
}

// The digits of a number at the begin of a text, and what stands behind.
struct Numeral {
    std::string_view digits, unit;
};

Numeral numeral_of(std::string_view text, Dimension dimension) {
    text = without_plus(text);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number))
        refuse_uncertain("a number is due", dimension);
    const auto length = static_cast<std::size_t>(end - text.data());
    return {text.substr(0, length), trimmed(text.substr(length))};
}

double in_si(std::string_view number, std::string_view unit, Dimension dimension) {
    if (dimension != Dimension::none)
        return parse_quantity(std::string(number) + ' ' + std::string(unit), dimension);
    if (!unit.empty()) refuse_uncertain("a pure number has no unit", dimension);
    double value = 0;
    std::from_chars(number.data(), number.data() + number.size(), value);
    return value;
}

// "4.56e-3" -> "0.005e-3"
std::string half_digit_of(std::string_view digits) {
    const auto exponent = digits.find_first_of("eE");
    const std::string_view mantissa = digits.substr(0, exponent);
    const auto point = mantissa.find('.');
    const std::size_t decimals = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
    std::string half = "0." + std::string(decimals, '0') + "5";
    return exponent == std::string_view::npos ? half : half.append(digits.substr(exponent));
}

}  // namespace

bool states_uncertainty(std::string_view text) {
    return halves_of(text).error.has_value();
}

UncertainNumber parse_uncertain_number(std::string_view text, Dimension dimension) {
    UncertainNumber number;
    if (states_uncertainty(text)) number.distribution = take_distribution(text, dimension);
    const auto [value_text, error_text] = halves_of(text);
    const Numeral value = numeral_of(value_text, dimension);
    if (!error_text) {
        number.value = {in_si(value.digits, value.unit, dimension)};
        number.half_digit = in_si(half_digit_of(value.digits), value.unit, dimension);
        return number;
    }
    if (error_text->empty()) refuse_uncertain("the error behind ± is missing", dimension);
    Numeral error = numeral_of(*error_text, dimension);
    const bool relative = error.unit == percent_sign;
    if (!value.unit.empty() && error.unit.empty() && dimension != Dimension::none)
        refuse_uncertain("the error behind ± has no unit", dimension);
    const std::string_view unit = relative || !value.unit.empty() ? value.unit : error.unit;
    const double written = in_si(value.digits, unit, dimension);
    number.half_digit = in_si(half_digit_of(value.digits), unit, dimension);
    double spread = 0;  // what is written behind the sign
    if (relative) {
        spread = in_si(error.digits, {}, Dimension::none) / 100 * std::abs(written);
        if (written == 0) refuse_uncertain("an error in percent of zero is undefined", dimension);
    } else {
        spread = in_si(error.digits, error.unit, dimension);
        number.half_error_digit = in_si(half_digit_of(error.digits), error.unit, dimension);
    }
    if (!(spread >= 0)) refuse_uncertain("an error must not be negative", dimension);
    number.value = {written, spread * standard_deviations(number.distribution)};
    return number;
}

}  // namespace tricontact::io
