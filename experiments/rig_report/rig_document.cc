#include <fmt/format.h>

#include <algorithm>

#include "experiments/rig_report/rig_report.h"

namespace tricontact::experiments {

namespace {

using report::Cell;
using report::DocumentSection;
using report::DocumentTable;
using report::Figure;
using report::Verdict;
using Agreement = PrintedCheck::Agreement;

// What is claimed, what follows, and what is missing.
std::vector<std::string> remarks(const Assumption& assumption) {
    std::vector<std::string> parts{assumption.claim + '.'};
    if (!assumption.consequence.empty()) parts.push_back(assumption.consequence);
    if (!assumption.missing.empty())
        parts.push_back(fmt::format("Not given: {}.", fmt::join(assumption.missing, ", ")));
    return parts;
}

/// The criterion that decides: of the worst standing the first.
const Criterion* deciding(const Assumption& assumption) {
    for (const auto standing : {Standing::violated, Standing::not_testable, Standing::holds})
        for (const Criterion& one : assumption.criteria)
            if (one.standing() == standing) return &one;
    return nullptr;
}

Verdict verdict_on(const RigReport& report, const Assumption& assumption) {
    Verdict verdict{assumption.standing(),
                    fmt::format("{}: {}", assumption.title, fmt::join(remarks(assumption), " "))};
    verdict.subject = assumption.title;
    if (const Criterion* one = deciding(assumption)) {
        const Calculation& c = one->calculation;
        verdict.number = fmt::format("{} = {}", c.symbol, text_of(c.result, c.unit));
        verdict.threshold = threshold_text(*one);
    }
    if (!assumption.missing.empty())
        verdict.number += fmt::format("{}not given: {}", verdict.number.empty() ? "" : "; ",
                                      fmt::join(assumption.missing, ", "));
    verdict.effect = effects_text(report, assumption.name);
    if (verdict.effect.empty()) verdict.effect = assumption.consequence;
    return verdict;
}

/// "Half-space, Fitted constants".
std::string titles_of(const RigReport& report, Standing standing) {
    std::vector<std::string> titles;
    for (const Assumption& one : report.assumptions)
        if (one.standing() == standing) titles.push_back(one.title);
    return fmt::format("{}", fmt::join(titles, ", "));
}

/// How many assumptions are violated, and which; those that could not be tested.
Verdict rig_answer(const RigReport& report) {
    const auto n_of = [&](Standing standing) {
        return std::ranges::count_if(report.assumptions,
                                     [&](const auto& one) { return one.standing() == standing; });
    };
    const auto n_violated = n_of(Standing::violated), n_open = n_of(Standing::not_testable);
    const auto n = std::ssize(report.assumptions);
    std::string text = n_violated == 0 ? fmt::format("None of {} assumptions is violated.", n)
                                       : titles_of(report, Standing::violated) + ".";
    if (n_open > 0)
        text += fmt::format(" Not testable with what is given: {}.",
                            titles_of(report, Standing::not_testable));
    return {n_violated > 0 ? Standing::violated
            : n_open > 0   ? Standing::not_testable
                           : Standing::holds,
            text,
            n_violated > 0 ? fmt::format("{} of {} assumptions violated", n_violated, n)
            : n_open > 0   ? fmt::format("{} of {} not testable", n_open, n)
                           : std::string("all hold")};
}

DocumentSection effects_section(const RigReport& report) {
    DocumentTable table{
        .id = "effects",
        .title = "What each assumption does to what is measured",
        .note = fmt::format(
            "Computed with the assumption over computed without it, minus 1; one standard error "
            "behind ±, or the most that it can be to either side. Static shifts are those at "
            "F_T = {} mu F_N.",
            coupling_tangential_ratio),
        .columns = report::columns("assumption", "measured", "effect")};
    for (const Assumption& assumption : report.assumptions)
        for (const MeasuredEffect& one : report.effects)
            if (one.assumption == assumption.name)
                table.rows.push_back({assumption.title, name_of(one.measured), text_of(one)});
    return {.id = "effects", .heading = "Effect on what is measured", .tables = {std::move(table)}};
}

DocumentTable criteria_table(const Assumption& assumption) {
    DocumentTable table{.id = assumption.name + "_criteria",
                        .title = "What decides",
                        .columns = report::columns("quantity", "formula", "source", "with",
                                                   "number", "must be", "since", "verdict")};
    for (const Criterion& one : assumption.criteria) {
        const Calculation& c = one.calculation;
        table.rows.push_back({c.symbol, c.formula, c.source, given_text(c),
                              text_of(c.result, c.unit), threshold_text(one), one.reason,
                              std::string(word_of(one.standing()))});
    }
    return table;
}

DocumentTable background_table(const Assumption& assumption) {
    DocumentTable table{
        .id = assumption.name + "_numbers",
        .title = "Further numbers",
        .columns = report::columns("quantity", "formula", "source", "with", "number")};
    for (const Calculation& c : assumption.background)
        table.rows.push_back(
            {c.symbol, c.formula, c.source, given_text(c), text_of(c.result, c.unit)});
    return table;
}

DocumentSection section_of(const Assumption& assumption) {
    DocumentSection section{
        .id = assumption.name,
        .heading = fmt::format("{}: {}", assumption.title, word_of(assumption.standing())),
        .paragraphs = remarks(assumption)};
    if (!assumption.criteria.empty()) section.tables.push_back(criteria_table(assumption));
    if (!assumption.background.empty()) section.tables.push_back(background_table(assumption));
    return section;
}

std::string flag_sentence(const PrintedCheck& check) {
    std::string text = fmt::format("{}, printed as {} in {}", check.calculation->symbol,
                                   check.printed.text, check.printed.source);
    if (check.agreement == Agreement::differs) {
        text += fmt::format(", does not follow: {}.", arithmetic(*check.calculation));
        if (!check.substitutes.empty())
            text += " The print would follow from " + substitutes_text(check) + '.';
    } else {
        text += fmt::format(" ({}): {}.", word_of(check.agreement), arithmetic(*check.calculation));
    }
    if (const std::string error = error_text(check); !error.empty())
        text += fmt::format(" And {}.", error);
    return text;
}

DocumentSection printed_section(const std::vector<PrintedCheck>& printed) {
    DocumentSection section{.id = "printed", .heading = "Printed numbers that follow from others"};
    for (const PrintedCheck& check : printed)
        if (check.calculation && (check.agreement == Agreement::differs || !check.error_agrees))
            section.paragraphs.push_back(flag_sentence(check));
    DocumentTable table{
        .id = "printed_numbers",
        .title = "Print and arithmetic",
        .note =
            "Agrees: equal when rounded to the printed digits. Each value that stands in the last "
            "column would alone lead to the print.",
        .columns = report::columns("quantity", "source", "printed", "computed", "formula", "with",
                                   "printed/computed", "verdict", "follows from")};
    for (const PrintedCheck& check : printed) {
        const bool known = check.calculation.has_value();
        const Calculation& c =
            known ? *check.calculation : Calculation{.symbol = check.printed.name};
        std::string verdict = word_of(check.agreement);
        if (const std::string error = error_text(check); !error.empty()) verdict += "; " + error;
        table.rows.push_back({c.symbol, check.printed.source, check.printed.text,
                              known ? text_of(c.result, c.unit) : "", c.formula, given_text(c),
                              known ? Cell(check.ratio) : Cell(""), verdict,
                              substitutes_text(check)});
    }
    section.tables.push_back(std::move(table));
    return section;
}

std::vector<double> in(double unit, std::vector<double> values) {
    for (double& value : values) value /= unit;
    return values;
}

// Hertz dashed, the layer, and what was measured.
Figure force_figure(const ForceCurves& curves, const char* id, const char* title, const char* label,
                    const ForceCurves::ByTheory& by) {
    constexpr double mm = 1e-3;
    return {.id = id,
            .title = title,
            .caption = fmt::format(
                "Exact frictionless contact of the rig's sphere with its bonded layer, and Hertz' "
                "contact with a half-space of the same E_2; the rig has F_N = {}.",
                text_of(curves.rig_force, "N")),
            .x = {"normal force F_N [N]"},
            .y = {label},
            .curves = {{.name = "half-space (Hertz)",
                        .x = curves.force,
                        .y = in(mm, by.hertz),
                        .theory = true},
                       {.name = "layer", .x = curves.force, .y = in(mm, by.layer)}}};
}

void add_figures(DocumentSection& section, const ForceCurves& curves) {
    Figure diameter = force_figure(curves, "diameter", "Contact diameter",
                                   "contact diameter 2a [mm]", curves.diameter);
    if (const auto& measured = curves.measured_diameter)
        diameter.curves.push_back({.name = "measured",
                                   .x = {curves.rig_force.value},
                                   .y = {1e3 * measured->value},
                                   .y_error = {1e3 * measured->standard_error},
                                   .kind = report::Curve::Kind::points});
    section.figures.push_back(std::move(diameter));
    section.figures.push_back(force_figure(curves, "indentation", "Indentation",
                                           "indentation d [mm]", curves.indentation));
}

/// "contact radius 4.56 mm; indentation 0.52 mm": printed numbers that `flagged` picks.
template <class Flagged>
std::string names_of(const std::vector<PrintedCheck>& printed, const Flagged& flagged) {
    std::string names;
    for (const PrintedCheck& check : printed) {
        if (!check.calculation || !flagged(check)) continue;
        std::string name = check.printed.name;
        std::ranges::replace(name, '_', ' ');
        names += fmt::format("{}{} {}", names.empty() ? "" : "; ", name, check.printed.text);
    }
    return names;
}

/// The number of printed values that follow from others, and those that differ from them.
std::string printed_sentences(const std::vector<PrintedCheck>& printed) {
    const auto differs = [](const auto& check) { return check.agreement == Agreement::differs; };
    const auto n_computed = std::ranges::count_if(
        printed, [](const auto& check) { return check.calculation.has_value(); });
    const auto n_differ = std::ranges::count_if(printed, differs);
    const std::string wrong_error = names_of(
        printed, [&](const auto& check) { return !check.error_agrees && !differs(check); });
    std::vector<std::string> sentences;
    if (n_computed < std::ssize(printed))
        sentences.push_back(fmt::format("{} of {} printed numbers can be computed from the others.",
                                        n_computed, printed.size()));
    if (n_computed > 0 && n_differ == 0)
        sentences.push_back(fmt::format(
            "All that can be computed ({}) follow from the others, rounded or within their errors.",
            n_computed));
    if (n_differ > 0)
        sentences.push_back(
            fmt::format("{} of {} printed numbers do not follow from the others: {}.", n_differ,
                        n_computed, names_of(printed, differs)));
    if (!wrong_error.empty())
        sentences.push_back(
            fmt::format("Printed with an error that does not follow: {}.", wrong_error));
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace

report::Document rig_document(const Rig& rig, const RigReport& report) {
    report::Document document{
        .kind = "Assumptions of an experiment",
        .title = report.title,
        .lead =
            "What the evaluation of this rig assumes, each assumption with the "
            "number that decides, its threshold and what follows; and the "
            "published numbers beside what follows from the others.",
        .files = {{"all numbers (JSON)", "rig.json"}}};
    document.answer = rig_answer(report);
    if (!report.effects.empty()) document.sections.push_back(effects_section(report));
    for (const Assumption& assumption : report.assumptions) {
        document.verdicts.push_back(verdict_on(report, assumption));
        document.sections.push_back(section_of(assumption));
        if (assumption.name != "half_space") continue;
        if (const auto curves = force_curves(rig)) add_figures(document.sections.back(), *curves);
    }
    if (!report.printed.empty()) {
        document.verdicts.push_back({.sentence = printed_sentences(report.printed)});
        document.sections.push_back(printed_section(report.printed));
    }
    return document;
}

}  // namespace tricontact::experiments
