#include "report/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "contact/models/model_kind.h"

namespace tricontact::report {

static constexpr double least_p = 1e-3;

std::string as_given(double value) {
    std::string text = significant(value, 6);
    const std::size_t power = std::min(text.find("·"), text.size());
    if (text.find('.') >= power) return text;
    std::size_t end = power;
    while (text[end - 1] == '0') --end;
    if (text[end - 1] == '.') --end;
    return text.erase(end, power - end);
}

static char capital(char letter) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
}

std::string capitalised(std::string text) {
    if (!text.empty()) text.front() = capital(text.front());
    return text;
}

std::string percent(std::optional<double> ratio) {
    if (!ratio || !std::isfinite(*ratio)) return significant({});
    const double value = 100 * (*ratio - 1);
    const int decimals = std::abs(value) < 0.995 ? 2 : (std::abs(value) < 99.95 ? 1 : 0);
    const std::string text = fmt::format("{:+.{}f}", value, decimals);
    // A difference below what is shown has no sign.
    if (text.find_first_not_of("+-0.") == std::string::npos) return text.substr(1) + " %";
    return (text.front() == '-' ? "−" : "+") + text.substr(1) + " %";
}

std::string share(double part, int digits) {
    if (part != 0 && std::abs(part) < 1e-5) return "below 0.001 %";
    return significant(100 * part, digits) + " %";
}

std::string signed_share(double part, int digits) {
    return (part > 0 ? "+" : "") + significant(100 * part, digits) + " %";
}

std::string p_value(double p) {
    return p < least_p ? "p < 0.001" : "p = " + significant(p, 2);
}

std::string p_number(double p) {
    return p < least_p ? "< 0.001" : significant(p, 2);
}

std::string apart(double ratio, const std::string& more, const std::string& less) {
    return significant(100 * std::abs(ratio - 1), 3) + " % " + (ratio < 1 ? less : more);
}

Unit fitting_unit(double magnitude, const std::string& base) {
    // A unit that has its prefix takes no other one: 490 g, and 2.5 kg.
    constexpr double kilogram = 1e3;  // in grams
    if (base.starts_with("kg")) {
        if (base != "kg" || std::abs(magnitude) >= 1 || magnitude == 0) return {1, base};
        const contact::UnitPrefix prefix = contact::fitting_prefix(kilogram * magnitude);
        return {prefix.factor / kilogram, std::string(prefix.symbol) + "g"};
    }
    if (base == "m2") {  // the prefix is squared with the metre
        const contact::UnitPrefix prefix = contact::fitting_prefix(std::sqrt(std::abs(magnitude)));
        return {prefix.factor * prefix.factor, prefix.symbol + base};
    }
    const contact::UnitPrefix prefix = contact::fitting_prefix(magnitude);
    return {prefix.factor, prefix.symbol + base};
}

std::string given_quantity(double value, const std::string& base) {
    const Unit unit = fitting_unit(value, base);
    return as_given(value / unit.factor) + " " + unit.symbol;
}

std::string display_name(const std::string& model) {
    if (const auto* kind = contact::find_model_kind(model)) return kind->title;
    std::string name = model;
    for (std::size_t i = 0; i < std::min(model.find('-'), model.size()); ++i)
        name[i] = capital(name[i]);
    std::ranges::replace(name, '-', ' ');
    return name;
}

std::optional<int> model_style(const std::string& model) {
    for (const contact::ModelKind& kind : contact::model_kinds())
        if (model == kind.name || model == kind.title) return kind.style;
    return {};
}

std::string id_of_model(std::string model) {
    std::ranges::replace(model, '-', '_');
    return model;
}

std::string display_names(const std::vector<std::string>& models) {
    std::string text;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (i > 0) text += i + 1 == models.size() ? " and " : ", ";
        text += display_name(models[i]);
    }
    return text;
}

}  // namespace tricontact::report
