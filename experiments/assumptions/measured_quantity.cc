#include "experiments/assumptions/measured_quantity.h"

#include <charconv>
#include <cmath>
#include <string>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::experiments {

namespace {

struct Halves {
    std::string_view value, error;  // error empty: there is none
};

Halves split(std::string_view text) {
    for (const std::string_view sign : {"±", "+-"})
        if (const auto at = text.find(sign); at != std::string_view::npos)
            return {io::trimmed(text.substr(0, at)), io::trimmed(text.substr(at + sign.size()))};
    return {io::trimmed(text), {}};
}

std::string example_with_error(io::Dimension dimension) {
    return "write " + std::string(io::name_of(dimension)) + " such as " +
           io::toml_string(io::example_of(dimension)) + ", with an error \"1.55 ± 0.13" +
           (dimension == io::Dimension::none ? "" : " " + std::string(io::si_unit(dimension))) +
           '"';
}

[[noreturn]] void refuse(const std::string& rule, io::Dimension dimension) {
    throw io::QuantityError{rule, example_with_error(dimension)};
}

// The digits of a number at the begin of a text, and what stands behind.
struct Numeral {
    std::string_view digits, rest;
};

Numeral numeral_of(std::string_view text, io::Dimension dimension) {
    text = io::without_plus(text);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) refuse("a number is due", dimension);
    const auto length = static_cast<std::size_t>(end - text.data());
    return {text.substr(0, length), io::trimmed(text.substr(length))};
}

double in_si(std::string_view number, std::string_view unit, io::Dimension dimension) {
    if (dimension != io::Dimension::none)
        return io::parse_quantity(std::string(number) + ' ' + std::string(unit), dimension);
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
    if (exponent != std::string_view::npos) half += digits.substr(exponent);
    return half;
}

}  // namespace

MeasuredQuantity parse_measured_quantity(std::string_view text, io::Dimension dimension) {
    const Halves halves = split(text);
    const Numeral value = numeral_of(halves.value, dimension);
    const bool has_error = text.size() > halves.value.size() && !halves.error.empty();
    if (!has_error) {
        if (halves.value != io::trimmed(text)) refuse("the error behind ± is missing", dimension);
        if (dimension == io::Dimension::none && !value.rest.empty())
            refuse("a pure number has no unit", dimension);
        return {{in_si(value.digits, value.rest, dimension), 0},
                in_si(half_digit_of(value.digits), value.rest, dimension),
                0};
    }
    const Numeral error = numeral_of(halves.error, dimension);
    if (!value.rest.empty())
        refuse("the unit of value and error stands once, behind the error", dimension);
    if (dimension == io::Dimension::none && !error.rest.empty())
        refuse("a pure number has no unit", dimension);
    const std::string_view unit = error.rest;
    const double standard_error = in_si(error.digits, unit, dimension);
    if (!(standard_error >= 0)) refuse("an error must not be negative", dimension);
    return {{in_si(value.digits, unit, dimension), standard_error},
            in_si(half_digit_of(value.digits), unit, dimension),
            in_si(half_digit_of(error.digits), unit, dimension)};
}

}  // namespace tricontact::experiments
