// Laws of friction that were compared: sentences, table and JSON.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "contact/base/special_values.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/law_parameters.h"
#include "io/keys/messages.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

std::string number_text(const LawFit& fit, std::size_t k) {
    const bool is_at_reference = fit.law->has_exponent && fit.found.free[k].symbol == "mu" &&
                                 std::isfinite(fit.found.parameters[k].likelihood.high);
    return found_text(fit.found, k) +
           (is_at_reference ? " at p_r = " + report::given_quantity(
                                                 *fit.input.rig.friction.reference_pressure, "Pa")
                            : "");
}

Verdict law_supported(const LawComparison& laws) {
    const auto left = laws.supported();
    if (left.empty())
        return {fail,
                "None of the laws of friction compared explains the tables; their numbers are not "
                "to be used before the reason is known."};
    if (laws.laws.size() == 1)
        return {finding, fmt::format("One law of friction, {}, was named: it was not compared.",
                                     law_name(laws.laws.front()))};
    if (laws.named) {
        const LawFit& fit = laws.laws[*laws.named];
        return {finding,
                fmt::format("The data support the law of friction {}: {}.", law_name(fit),
                            left.size() == 1
                                ? "the others are excluded"
                                : "what contains it adds nothing that matters, the others are "
                                  "excluded"),
                "law of friction"};
    }
    std::string sentence = "These data cannot tell the laws of friction " +
                           io::joined(left, [&](std::size_t i) { return law_name(laws.laws[i]); }) +
                           " apart.";
    for (const std::size_t i : left)
        if (!laws.laws[i].not_told_from.empty())
            sentence += fmt::format(" Beside {} there is room for {}.", laws.laws[i].law->name,
                                    laws.laws[i].not_told_from);
    return {not_resolved,
            sentence + " Measure the force of full sliding over a wider range of loads."};
}

std::optional<Verdict> laws_excluded(const LawComparison& laws) {
    std::string sentence;
    for (const LawFit& fit : laws.laws)
        if (fit.is_excluded())
            sentence += fmt::format("{}{} ({})", sentence.empty() ? "Excluded: " : "; ",
                                    law_name(fit), fit.why_excluded);
    if (sentence.empty()) return {};
    return Verdict{finding, sentence + "."};
}

/// What E is under each law that is left, where these are several.
std::optional<Verdict> numbers_of_others(const LawComparison& laws) {
    std::string sentence;
    for (const std::size_t i : laws.supported())
        if (i != laws.best)
            sentence += fmt::format("{}under {} {}", sentence.empty() ? "Not excluded: " : "; ",
                                    laws.laws[i].law->name, law_numbers(laws.laws[i]));
    if (sentence.empty()) return {};
    return Verdict{finding, sentence + "."};
}

std::optional<Verdict> would_slide(const LawFit& fit) {
    if (fit.largest_held_share <= 1) return {};
    return Verdict{
        not_resolved,
        fmt::format("Under {} at its best values the largest force that held is {} % "
                    "above what friction carries.",
                    fit.law->name, report::significant(100 * (fit.largest_held_share - 1), 2))};
}

/// The fit of Coulomb's law that was asked for, beside a strength that nobody asked for; empty
/// where neither explains the tables, which other sentences say.
std::optional<Verdict> coulomb_beside_strength(const LawComparison& laws) {
    const LawFit &coulomb = laws.laws.front(), &strength = laws.laws.back();
    const std::string both = fmt::format("AICc {} and {}", report::significant(coulomb.aicc, 4),
                                         report::significant(strength.aicc, 4));
    if (strength.is_excluded() && coulomb.is_excluded()) return {};
    if (strength.is_excluded())
        return Verdict{holds, fmt::format("On a half-space a shear strength in place of Coulomb's "
                                          "law is excluded ({}).",
                                          strength.why_excluded)};
    const std::string what_to_do =
        " Measure under several loads, and compare the laws by measurement.laws.";
    if (coulomb.is_excluded())
        return Verdict{violated,
                       fmt::format("Coulomb's law was assumed, and a half-space with a shear "
                                   "strength excludes it ({}): {}. E and mu are not to be used.{}",
                                   coulomb.why_excluded, law_numbers(strength), what_to_do)};
    return Verdict{
        not_resolved,
        fmt::format("Coulomb's law is assumed, and not told from a shear strength, which explains "
                    "the tables {} on a half-space ({}): {}.{}",
                    strength.aicc < coulomb.aicc ? "better" : "nearly as well", both,
                    law_numbers(strength), what_to_do)};
}

/// Numbers of another law than Coulomb's were found.
std::optional<Verdict> law_stated(const IdentificationStudy& study) {
    const auto tau =
        std::ranges::find(study.settings, "tau", [](const auto& s) { return s.first; });
    const auto is_found = [](const FreeParameter& p) { return is_of_law(p.key); };
    if (tau == study.settings.end() || std::ranges::none_of(study.input.parameters, is_found))
        return {};
    return Verdict{finding, fmt::format("One law of friction, tau = {}, was stated: it was not "
                                        "compared (measurement.laws).",
                                        tau->second)};
}

}  // namespace

std::string law_name(const LawFit& fit) {
    return fmt::format("{} ({})", fit.law->name, fit.law->formula);
}

std::string law_numbers(const LawFit& fit) {
    std::string text;
    for (std::size_t k = 0; k < fit.found.free.size(); ++k)
        text += (k == 0 ? "" : ", ") + number_text(fit, k);
    return text;
}

std::vector<Verdict> law_verdicts(const IdentificationStudy& study) {
    std::vector<Verdict> verdicts;
    if (!study.laws) {
        if (auto verdict = law_stated(study)) verdicts.push_back(std::move(*verdict));
        return verdicts;
    }
    const LawComparison& laws = *study.laws;
    if (study.input.laws.empty()) {
        // Where the layer matters, the half-space's comparison is that of a wrong model; a strength
        // that leaves no pattern explains the tables.
        const auto half_space = half_space_of(study);
        const bool explains = !laws.laws.back().is_excluded();
        if (half_space != study.models.end() && !is_rejected(*half_space) &&
            (explains || half_space->found.goodness || !half_space->found.has_strong_pattern()))
            if (auto verdict = coulomb_beside_strength(laws))
                verdicts.push_back(std::move(*verdict));
        return verdicts;
    }
    verdicts.push_back(law_supported(laws));
    if (auto verdict = laws_excluded(laws)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = numbers_of_others(laws)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = would_slide(laws.laws[laws.best])) verdicts.push_back(std::move(*verdict));
    return verdicts;
}

report::DocumentTable law_table(const LawComparison& laws) {
    report::DocumentTable table{
        .id = "laws",
        .title = "Laws of friction",
        .note =
            "-2 ln L: without a constant. AICc: Akaike's criterion for few observations, less "
            "is better. p: of the likelihood ratio beside the law that contains this one and "
            "takes most away from it.",
        .columns =
            report::columns("law", "tau", "numbers", "-2 ln L:5", "AICc:5", "above the least:3",
                            "likelihood ratio:3", "beside", "p", "verdict")};
    for (const LawFit& fit : laws.laws) {
        const auto test = std::ranges::min_element(fit.wider, {}, &NestedTest::chance);
        const bool has = test != fit.wider.end();
        table.rows.push_back(
            {std::string(fit.law->name), std::string(fit.law->formula), law_numbers(fit),
             fit.minus_two_log_likelihood, fit.aicc, fit.aicc_difference,
             has ? test->likelihood_ratio : contact::undefined,
             has ? std::string(test->wider->name) : "",
             report::p_number(has ? test->chance : contact::undefined),
             fit.is_excluded() ? "excluded: " + fit.why_excluded : "not excluded"});
    }
    return table;
}

std::string law_lines(const LawComparison& laws) {
    std::string text = fmt::format("{:<22} {:>10} {:>8}  {:<24} {}\n", "law of friction", "AICc",
                                   "+", "likelihood ratio", "numbers");
    for (const LawFit& fit : laws.laws) {
        const auto test = std::ranges::min_element(fit.wider, {}, &NestedTest::chance);
        text += fmt::format(
            "{:<22} {:>10} {:>8}  {:<24} {}\n", fit.law->name, report::significant(fit.aicc, 5),
            report::significant(fit.aicc_difference, 3),
            test == fit.wider.end()
                ? ""
                : fmt::format("{}, {}", report::significant(test->likelihood_ratio, 3),
                              report::p_value(test->chance)),
            law_numbers(fit));
    }
    return text;
}

nlohmann::ordered_json law_json(const LawComparison& laws) {
    using json = nlohmann::ordered_json;
    json result = json::object();
    for (const LawFit& fit : laws.laws) {
        json one{{"formula", fit.law->formula}};
        for (std::size_t k = 0; k < fit.found.free.size(); ++k) {
            const auto& estimate = fit.found.parameters[k];
            one[fit.found.free[k].name] = {
                {"value", estimate.value},
                {"likelihood_interval", {estimate.likelihood.low, estimate.likelihood.high}}};
        }
        if (fit.law->has_exponent)
            one["reference_pressure_Pa"] = *fit.input.rig.friction.reference_pressure;
        one["minus_two_log_likelihood"] = fit.minus_two_log_likelihood;
        one["n_fitted"] = fit.n_fitted;
        one["aicc"] = fit.aicc;
        one["aicc_above_least"] = fit.aicc_difference;
        one["goodness"] = fit.found.goodness;
        one["has_strong_pattern"] = fit.found.has_strong_pattern();
        one["beside_wider"] = json::object();
        for (const NestedTest& test : fit.wider)
            one["beside_wider"][std::string(test.wider->name)] = {
                {"likelihood_ratio", test.likelihood_ratio}, {"chance", test.chance}};
        one["largest_held_share"] = fit.largest_held_share;
        one["is_excluded"] = fit.is_excluded();
        one["reason"] = fit.why_excluded;
        one["not_told_from"] = fit.not_told_from;
        result[std::string(fit.law->name)] = std::move(one);
    }
    json all{{"compared", std::move(result)}};
    all["named"] = laws.named ? json(laws.laws[*laws.named].law->name) : json(nullptr);
    return all;
}

}  // namespace tricontact::experiments
