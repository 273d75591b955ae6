// A comparison as a report.

#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/report/comparison_figures.h"
#include "benchmarks/report/comparison_output.h"
#include "benchmarks/report/comparison_tables.h"
#include "benchmarks/report/comparison_words.h"
#include "comparisons/run/report_tables.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

using report::DocumentSection;
using report::DocumentTable;
using VerdictOf = report::Verdict::Standing;

std::vector<DocumentTable> without_empty(std::vector<DocumentTable> tables) {
    std::erase_if(tables, [](const DocumentTable& table) { return table.rows.empty(); });
    return tables;
}

/// What is said first: the quantity that has a budget, else the first one.
const ComparedNumber* leading_number(const Comparison& comparison) {
    const auto& numbers = comparison.numbers;
    const auto has_budget = [](const ComparedNumber& one) {
        return !one.is_norm && !one.explained.empty();
    };
    const auto found = std::ranges::find_if(numbers, has_budget);
    if (found != numbers.end()) return &*found;
    return numbers.empty() ? nullptr : &numbers.front();
}

std::string counts_of(const Comparison& comparison) {
    const auto number_of = [&](Standing standing) {
        return std::ranges::count(comparison.numbers, standing, &ComparedNumber::standing);
    };
    return fmt::format("of {} numbers {} pass, {} fail, {} are not resolved",
                       comparison.numbers.size(), number_of(Standing::pass),
                       number_of(Standing::fail), number_of(Standing::not_resolved));
}

report::Verdict answer_on(const Comparison& comparison) {
    std::string text = fmt::format("{}: {}.", comparison.title, counts_of(comparison));
    if (const ComparedNumber* leading = leading_number(comparison))
        text += ' ' + report::capitalised(budget_sentence(*leading)) + '.';
    if (comparison.standing == Standing::not_resolved && !comparison.blame.empty())
        text += " Largest term of U: " + comparison.blame + '.';
    return {standing_of(comparison.standing), text};
}

/// An id as words, which a narrow column can break.
std::string spaced(std::string id) {
    std::ranges::replace(id, '_', ' ');
    return id;
}

std::vector<report::Verdict> verdicts_on(const Comparison& comparison) {
    std::vector<report::Verdict> verdicts{
        {standing_of(comparison.unexplained_standing),
         "The verdict without explained differences: every difference counts in full."}};
    for (const std::string& sentence : comparison.sentences)
        verdicts.push_back({VerdictOf::finding, sentence});
    for (const Diagnosis& one : comparison.diagnoses)
        verdicts.push_back({VerdictOf::finding,
                            one.sentence + (one.remedy.empty() ? "" : ". Remedy: " + one.remedy),
                            spaced(one.id)});
    for (const ComparedNumber& one : comparison.numbers)
        if (one.standing == Standing::not_resolved && !one.remedy.empty())
            verdicts.push_back(
                {VerdictOf::not_resolved,
                 fmt::format("{}: {}{}", one.title,
                             one.blame.empty() ? "" : "because " + one.blame + "; ", one.remedy)});
    return verdicts;
}

DocumentSection budget_section(const Comparison& comparison) {
    DocumentSection section{
        .id = "explained",
        .heading = "What explains the differences",
        .paragraphs = {},
        .tables = without_empty({numbers_table(comparison), budget_table(comparison)}),
        .printed = true,
        .open = true};
    for (const ComparedNumber& one : comparison.numbers)
        if (!one.explained.empty()) section.figures.push_back(budget_figure(one));
    section.figures.push_back(left_figure(comparison));
    section.paragraphs.push_back(
        section.tables.size() < 2
            ? "Nothing is taken from the differences: the submission gives no penalty, no stick "
              "slope, no kinematics and no block whose effect is known, and none was found."
            : "Each effect is computed from the fields of the reference at three neighbouring "
              "depths or shifts, to first order. Its bar is part of U. The verdict without it "
              "stands beside the verdict with it.");
    return section;
}

DocumentSection reference_section(const Comparison& comparison) {
    const Reference& reference = comparison.reference;
    DocumentSection section{.id = "reference",
                            .heading = "The reference and its bar",
                            .paragraphs = {},
                            .tables = {reference_table(comparison)}};
    if (!reference.models.empty())
        section.paragraphs.push_back("Models behind the reference, that of the fields first: " +
                                     report::display_names(reference.models) + '.');
    for (const std::string& remark : reference.remarks) section.paragraphs.push_back(remark);
    return section;
}

DocumentSection submission_section(const Comparison& comparison) {
    DocumentSection section{
        .id = "submission",
        .heading = "Meshes and submission",
        .paragraphs = {},
        .tables = without_empty({mesh_table(comparison), submission_table(comparison)})};
    std::vector<std::string> notes;
    for (const MeshField& mesh : comparison.submission.meshes)
        for (const std::string& note : mesh.notes)
            if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    if (!notes.empty())
        section.paragraphs.push_back(
            fmt::format("How the files were read: {}.", fmt::join(notes, "; ")));
    return section;
}

DocumentSection method_section() {
    return {.id = "method",
            .heading = "How the verdict is made",
            .paragraphs = {
                "In the words of the standard V&V 20, ASME (2009): the comparison error E is the "
                "code's value "
                "minus that of the reference, S - D. It is compared with the uncertainty U of the "
                "comparison, which joins the numerical uncertainty of the code (discretisation), "
                "the uncertainty of the reference in the place of the experimental one, and the "
                "uncertainty of what is explained, in place of that of the input: U² is the sum "
                "of their squares. An |E| below U says that the difference is within the noise of "
                "the comparison; an |E| far above U estimates the error of the model.",
                "Beyond that standard a tolerance τ is given: pass where |E| + U <= τ, fail where "
                "|E| - U > τ, else not resolved. E is taken from the limit of the family of "
                "meshes, where it converges in a plausible order, else from the finest mesh.",
                "Discretisation: Roache's grid convergence index (Roache 1998), with the observed "
                "order but at most 2; the spread of the values where no order can be relied on."}};
}

}  // namespace

report::Document comparison_document(const Comparison& comparison) {
    report::Document document{
        .kind = "Benchmark",
        .title =
            fmt::format("{} on {}", report::capitalised(code_of(comparison)), comparison.title),
        .lead =
            "How far is the code from the reference, at which order does it converge, and "
            "what explains the difference?",
        .answer = answer_on(comparison),
        .comparison = verdict_rows(comparison),
        .verdicts_heading = "Without explanation, and what the numbers show",
        .verdicts = verdicts_on(comparison),
        .input = case_text(comparison)};
    if (!document.input.empty())
        document.settings = comparisons::settings_of(comparison.reference.c);
    const ComparedNumber* leading = leading_number(comparison);
    DocumentSection budget = budget_section(comparison);
    if (leading && !leading->explained.empty()) {
        document.figure = std::move(budget.figures.front());
        budget.figures.erase(budget.figures.begin());
    }
    document.sections = {
        std::move(budget),
        {.id = "convergence_section",
         .heading = "Convergence",
         .figures = error_figures(comparison),
         .tables = {convergence_table(comparison), values_table(comparison)},
         .open = true},
        {.id = "fields", .heading = "Fields", .figures = profile_figures(comparison), .open = true},
        {.id = "found",
         .heading = "Conventions and diagnoses",
         .tables = without_empty({convention_table(comparison), diagnosis_table(comparison)})},
        reference_section(comparison),
        submission_section(comparison),
        method_section()};
    auto& fields = document.sections[2].figures;
    for (auto& more : {load_figures(comparison), difference_maps(comparison)})
        fields.insert(fields.end(), more.begin(), more.end());
    document.files = {{"all numbers (JSON)", "comparison.json"},
                      {"a row per number and mesh (CSV)", "comparison.csv"},
                      {"for continuous integration", "junit.xml"}};
    return document;
}

}  // namespace tricontact::benchmarks
