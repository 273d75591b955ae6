#include "benchmarks/report/comparison_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/resolution/error_note.h"
#include "io/case/case_reader.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::benchmarks {

const char* words_of(ContactMethod::Kind kind) {
    constexpr const char* words[] = {
        "not given", "penalty", "augmented Lagrangian", "Lagrange multipliers",
        "mortar",    "Nitsche"};
    return words[static_cast<int>(kind)];
}

const char* words_of(ContactMethod::Kinematics kinematics) {
    constexpr const char* words[] = {"not given", "undeformed surface", "displaced surface",
                                     "finite strains"};
    return words[static_cast<int>(kinematics)];
}

std::optional<double> difference_of(const ComparedNumber& number, std::size_t k) {
    if (k >= number.values.size() || !number.values[k]) return {};
    if (number.is_norm) return *number.values[k];
    if (number.reference.value == 0) return {};
    return *number.values[k] / number.reference.value - 1;
}

namespace {

/// A unit whose prefixes count twice: what is shown instead, and its size.
struct ShownUnit {
    std::string name;
    double size = 1;
    bool takes_prefixes = true;
};

ShownUnit shown_unit(const ComparedNumber& number) {
    if (number.unit == "m2") return {"mm2", 1e-6, false};
    return {number.unit};
}

}  // namespace

std::string value_of(const ComparedNumber& number, std::optional<double> value) {
    if (!value || !std::isfinite(*value)) return report::significant({});
    if (number.is_norm) return report::share(*value, 3);
    const ShownUnit unit = shown_unit(number);
    if (!unit.takes_prefixes) return report::significant(*value / unit.size) + ' ' + unit.name;
    if (unit.name.empty()) return report::significant(*value, 5);
    return report::quantity(*value, unit.name, 5);
}

std::string reference_of(const ComparedNumber& number) {
    if (number.is_norm) return {};
    const double value = number.reference.value, bar = number.reference.bar();
    const ShownUnit unit = shown_unit(number);
    if (bar == 0) return value_of(number, value);
    if (unit.takes_prefixes && !unit.name.empty())
        return comparisons::value_text(value, unit.name.c_str(), bar);
    return report::with_error(value / unit.size, bar / unit.size) +
           (unit.name.empty() ? "" : ' ' + unit.name);
}

std::string left_text(double left, double uncertainty) {
    // Two digits of U: against a tolerance one is too coarse.
    const double u = 100 * uncertainty;
    if (!(u > 0) || !std::isfinite(left)) return report::signed_share(left);
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(u))), 0, 6);
    const double shown = std::abs(100 * left) < .5 * std::pow(10, -decimals) ? 0 : 100 * left;
    return fmt::format("{}{:.{}f} ± {:.{}f} %", shown < 0 ? "−" : "", std::abs(shown), decimals, u,
                       decimals);
}

std::string mesh_name(const Comparison& comparison, std::size_t k) {
    const MeshResult& mesh = comparison.meshes[k];
    if (!(mesh.size > 0)) return fmt::format("mesh {}", k + 1);
    // All in one unit, by which they are compared.
    const double millimetres = report::to_digits(1e3 * mesh.size, 3);
    return fmt::format("h = {} mm", report::as_given(millimetres));
}

std::string case_text(const Comparison& comparison) {
    const contact::Case& c = comparison.reference.c;
    return c.models.empty() ? "" : io::write_case(c);
}

std::string code_of(const Comparison& comparison) {
    const std::string& code = comparison.submission.code;
    return code.empty() ? "the code" : code;
}

report::Verdict::Standing standing_of(Standing standing) {
    using enum report::Verdict::Standing;
    return standing == Standing::pass ? pass : standing == Standing::fail ? fail : not_resolved;
}

std::string budget_sentence(const ComparedNumber& number) {
    std::string text =
        fmt::format("{}: {}", number.title,
                    number.is_norm ? report::share(number.difference, 3)
                                   : report::signed_share(number.difference) + " of the reference");
    for (std::size_t i = 0; i < number.explained.size(); ++i)
        text += fmt::format("{} {} {}", i == 0 ? " =" : ",", number.explained[i].title,
                            report::signed_share(number.explained[i].change));
    text +=
        fmt::format("{} {}; tolerance {}", number.explained.empty() ? "; with U:" : ", left",
                    left_text(number.left(), number.uncertainty), report::share(number.tolerance));
    return text;
}

}  // namespace tricontact::benchmarks
