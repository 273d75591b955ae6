#include <fmt/format.h>

#include <set>

#include "benchmarks/report/comparison_output.h"
#include "benchmarks/report/comparison_tables.h"
#include "benchmarks/report/comparison_words.h"
#include "report/table_text.h"

namespace tricontact::benchmarks {

namespace {

std::string verdict_lines(const Comparison& comparison) {
    const auto word = [](Standing standing) { return report::word_of(standing_of(standing)); };
    std::string text = fmt::format("{}: {} on {}", word(comparison.standing), code_of(comparison),
                                   comparison.title);
    if (comparison.standing == Standing::not_resolved && !comparison.blame.empty())
        text += fmt::format("; largest term of U: {}", comparison.blame);
    text += '\n';
    if (comparison.standing != comparison.unexplained_standing)
        text +=
            fmt::format("without what is explained: {}\n", word(comparison.unexplained_standing));
    return text;
}

std::string remedy_lines(const Comparison& comparison) {
    std::string text;
    for (const ComparedNumber& one : comparison.numbers)
        if (one.standing == Standing::not_resolved && !one.remedy.empty())
            text += fmt::format("{}: not resolved{}; {}\n", one.title,
                                one.blame.empty() ? "" : " for " + one.blame, one.remedy);
    return text;
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
    std::string text = verdict_lines(comparison);
    for (const ComparedNumber& one : comparison.numbers)
        if (!one.explained.empty()) text += budget_sentence(one) + '\n';
    for (const std::string& sentence : comparison.sentences) text += sentence + '\n';
    text += '\n' + report::table_text(numbers_table(comparison));
    if (comparison.meshes.size() > 1)
        text +=
            "\ndifferences on the meshes [%]\n" + report::table_text(convergence_table(comparison));
    if (!comparison.conventions.empty()) text += "\nconventions found\n";
    for (const Convention& one : comparison.conventions)
        text += fmt::format("{}: {} ({})\n", one.id, one.choice, one.number);
    std::set<std::string> noted;  // of most files the same
    for (const MeshField& mesh : comparison.submission.meshes)
        for (const std::string& note : mesh.notes)
            if (noted.insert(note).second) text += fmt::format("{}: {}\n", mesh.file, note);
    if (!comparison.diagnoses.empty()) text += "\ndiagnoses\n";
    for (const Diagnosis& one : comparison.diagnoses)
        text += fmt::format("{}: {}{}\n", one.id, one.sentence,
                            one.remedy.empty() ? "" : "\n    remedy: " + one.remedy);
    return text + remedy_lines(comparison);
}

}  // namespace tricontact::benchmarks
