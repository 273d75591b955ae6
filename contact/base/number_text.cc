#include "contact/base/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tricontact::contact {

namespace {

constexpr const char* no_number = "–";

std::string superscript(int exponent) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent))) result += digits[digit - '0'];
    return result;
}

/// Without the point that `#` leaves behind an integer, with a true minus.
std::string tidied(std::string text) {
    if (!text.empty() && text.back() == '.') text.pop_back();
    if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
    return text;
}

}  // namespace

std::string significant(std::optional<double> value, int digits) {
    if (!value || !std::isfinite(*value)) return no_number;
    if (*value == 0) return "0";
    // Rounding first: 9.9996 is 10.00, not 9.9996 with the exponent of 9.
    const std::string scientific = fmt::format("{:.{}e}", *value, digits - 1);
    const std::size_t split = scientific.find('e');
    const int exponent = std::stoi(scientific.substr(split + 1));
    if (exponent < -3 || exponent > 5)
        return tidied(scientific.substr(0, split)) + "·10" + superscript(exponent);
    return tidied(fmt::format("{:.{}f}", *value, std::max(0, digits - 1 - exponent)));
}

std::string with_error(double value, double error, int digits) {
    if (!std::isfinite(value)) return no_number;
    error = std::abs(error);
    if (!std::isfinite(error)) return significant(value, digits) + " ± " + no_number;
    if (error <= 1e-7 * std::abs(value))
        return significant(value, digits) + " ± " + significant(error, 1);
    // PDG (2024), Introduction, 5.3: 950 ... 999 rounds up and then shows two digits, "1.0".
    const std::string leading = fmt::format("{:.2e}", error);  // "1.19e-01"
    const int exponent = std::stoi(leading.substr(leading.find('e') + 1));
    const int last = leading.substr(0, 4) < "3.55" ? exponent - 1 : exponent;
    if (leading.substr(0, 4) >= "9.50") error = std::pow(10.0, exponent + 1);
    const double unit = std::pow(10.0, last);
    const double larger = std::max(std::abs(value), error);
    const int power = static_cast<int>(std::floor(std::log10(larger)));
    const bool scientific = power < -3 || power > 5;
    const int decimals = std::max(0, (scientific ? power : 0) - last);
    const double scale = scientific ? std::pow(10.0, -power) : 1;
    const auto rounded = [&](double number) {
        const double nearest = std::round(number / unit) * unit * scale + 0.0;  // no "−0"
        return tidied(fmt::format("{:.{}f}", nearest, decimals));
    };
    const std::string text = rounded(value) + " ± " + rounded(error);
    return scientific ? "(" + text + ")·10" + superscript(power) : text;
}

UnitPrefix fitting_prefix(double magnitude) {
    constexpr std::array prefixes{"p", "n", "µ", "m", "", "k", "M", "G", "T"};
    if (magnitude == 0 || !std::isfinite(magnitude)) return {};
    // 0.05 % of slack: 999.7 rounds to 1000 at three digits.
    const int step = static_cast<int>(std::floor(std::log10(std::abs(magnitude) * 1.0005) / 3));
    const int index = std::clamp(step + 4, 0, static_cast<int>(prefixes.size()) - 1);
    return {std::pow(10.0, 3 * (index - 4)), prefixes[index]};
}

std::string quantity(double value, const std::string& base, int digits) {
    const UnitPrefix prefix = fitting_prefix(value);
    return significant(value / prefix.factor, digits) + " " + prefix.symbol + base;
}

}  // namespace tricontact::contact
