#include "experiments/assumptions/measured_quantity.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::experiments {

namespace {

// Value, and error if there is one.
std::pair<std::string_view, std::optional<std::string_view>> split(std::string_view text) {
    for (const std::string_view sign : {"±", "+-"})
        if (const auto at = text.find(sign); at != std::string_view::npos)
            return {io::trimmed(text.substr(0, at)), io::trimmed(text.substr(at + sign.size()))};
    return {io::trimmed(text), {}};
}

[[noreturn]] void refuse(const std::string& rule, io::Dimension dimension) {
    const bool pure = dimension == io::Dimension::none;
    throw io::QuantityError{
        rule, "write " + std::string(io::name_of(dimension)) + " such as " +
                  io::toml_string(io::example_of(dimension)) + ", with an error \"1.55 ± 0.13" +
                  (pure ? "" : " " + std::string(io::si_unit(dimension))) + '"'};
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
    return exponent == std::string_view::npos ? half : half.append(digits.substr(exponent));
}

}  // namespace

MeasuredQuantity parse_measured_quantity(std::string_view text, io::Dimension dimension) {
    const auto [value_text, error_text] = split(text);
    const Numeral value = numeral_of(value_text, dimension);
    Numeral error{"0", value.rest};
    if (error_text) {
        if (error_text->empty()) refuse("the error behind ± is missing", dimension);
        error = numeral_of(*error_text, dimension);
        if (!value.rest.empty())
            refuse("the unit of value and error stands once, behind the error", dimension);
    }
    const std::string_view unit = error.rest;
    if (dimension == io::Dimension::none && !unit.empty())
        refuse("a pure number has no unit", dimension);
    const double standard_error = in_si(error.digits, unit, dimension);
    if (!(standard_error >= 0)) refuse("an error must not be negative", dimension);
    return {{in_si(value.digits, unit, dimension), standard_error},
            in_si(half_digit_of(value.digits), unit, dimension),
            error_text ? in_si(half_digit_of(error.digits), unit, dimension) : 0};
}

}  // namespace tricontact::experiments
