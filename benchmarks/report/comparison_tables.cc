#include "benchmarks/report/comparison_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "benchmarks/report/comparison_words.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

using Cells = std::vector<report::Cell>;
using Column = report::DocumentTable::Column;

report::Cell percent_cell_of(std::optional<double> part) {
    return report::number_cell(part, .01);
}

std::string verdict_word(Standing standing) {
    return report::word_of(standing_of(standing));
}

std::string given(std::optional<double> value, const char* unit) {
    return value ? report::given_quantity(*value, unit) : "not given";
}

Column percent_column(const std::string& heading) {
    return {.heading = heading, .digits = 3};
}

}  // namespace

report::DocumentTable verdict_rows(const Comparison& comparison) {
    report::DocumentTable table{
        .id = "verdicts_by_number",
        .title = "Verdicts",
        .note =
            "unexplained: the verdict if every difference counts in full. pass: |left| + U <= "
            "tolerance; fail: |left| - U > tolerance.",
        .columns =
            report::columns("quantity", "verdict", "unexplained", "left ± U [%]", "tolerance")};
    for (const ComparedNumber& one : comparison.numbers) {
        std::string left = left_text(one.left(), one.uncertainty);
        if (left.ends_with(" %")) left.resize(left.size() - 2);
        table.rows.push_back({one.title, verdict_word(one.standing),
                              verdict_word(one.unexplained_standing), left,
                              report::share(one.tolerance)});
    }
    return table;
}

report::DocumentTable numbers_table(const Comparison& comparison) {
    report::DocumentTable table{
        .id = "numbers",
        .title = "Numbers and verdicts",
        .note =
            "difference: E, of the limit of the family of meshes, or of the finest mesh where "
            "there is none, from the reference and relative to it. explained: effects "
            "predicted to first order. left: their difference. U joins "
            "discretisation, bar of the reference and bar of what is explained. pass: |left| + "
            "U <= tolerance; fail: |left| - U > tolerance.",
        .columns = {{"quantity"},
                    {"finest mesh"},
                    {"reference"},
                    percent_column("difference [%]"),
                    percent_column("explained [%]"),
                    percent_column("left [%]"),
                    {"U [%]", 2},
                    {"tolerance [%]", 2},
                    {"verdict"},
                    {"unexplained"}}};
    for (const ComparedNumber& one : comparison.numbers)
        table.rows.push_back(
            {one.title, value_of(one, one.values.empty() ? std::nullopt : one.values.back()),
             reference_of(one), percent_cell_of(one.difference),
             one.explained.empty() ? report::Cell(NAN) : percent_cell_of(one.explained_change()),
             percent_cell_of(one.left()), percent_cell_of(one.uncertainty),
             percent_cell_of(one.tolerance), verdict_word(one.standing),
             verdict_word(one.unexplained_standing)});
    return table;
}

report::DocumentTable convergence_table(const Comparison& comparison) {
    report::DocumentTable table{
        .id = "convergence",
        .title = "Differences on the meshes [%]",
        .note = comparison.is_family
                    ? "order: observed on the finest three meshes. discretisation: Roache's grid "
                      "convergence index with an order of at most 2; where the sequence has no "
                      "plausible order, its spread."
                    : "The meshes are not similar in every direction: they show no order, and "
                      "discretisation is the spread of their values.",
        .columns = {{"quantity"}}};
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k)
        table.columns.push_back(percent_column(mesh_name(comparison, k)));
    table.columns.insert(
        table.columns.end(),
        {{"order", 3}, {"expected order"}, {"sequence"}, {"discretisation [%]", 2}});
    for (const ComparedNumber& one : comparison.numbers) {
        Cells row{one.title};
        for (std::size_t k = 0; k < comparison.meshes.size(); ++k)
            row.push_back(percent_cell_of(difference_of(one, k)));
        row.push_back(report::number_cell(one.limit ? one.limit->order : std::nullopt));
        row.emplace_back(one.expected_order);
        row.emplace_back(one.limit ? comparisons::name_of(one.limit->convergence) : "");
        row.push_back(percent_cell_of(one.discretisation));
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::DocumentTable values_table(const Comparison& comparison) {
    report::DocumentTable table{.id = "values",
                                .title = "Values on the meshes",
                                .note = "SI units; norms are relative.",
                                .columns = report::columns("quantity", "unit"),
                                .folded = true};
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k)
        table.columns.push_back({mesh_name(comparison, k), 6});
    table.columns.push_back({"limit", 6});
    for (const ComparedNumber& one : comparison.numbers) {
        Cells row{one.title, one.unit};
        for (std::size_t k = 0; k < comparison.meshes.size(); ++k)
            row.push_back(
                report::number_cell(k < one.values.size() ? one.values[k] : std::nullopt));
        row.push_back(
            report::number_cell(one.limit ? std::optional(one.limit->value) : std::nullopt));
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::DocumentTable budget_table(const Comparison& comparison) {
    report::DocumentTable table{
        .id = "budget",
        .title = "What explains differences",
        .note = "Predicted to first order from the fields of the reference, over its value.",
        .columns = {{"quantity"}, {"effect"}, percent_column("change [%]"), {"bar [%]", 2}}};
    for (const ComparedNumber& one : comparison.numbers)
        for (const Explained& effect : one.explained)
            table.rows.push_back({one.title, effect.title, percent_cell_of(effect.change),
                                  percent_cell_of(effect.bar)});
    return table;
}

report::DocumentTable reference_table(const Comparison& comparison) {
    report::DocumentTable table{
        .id = "reference_values",
        .title = "The reference and its bar",
        .note =
            "Half widths over the value. grid: cells, elements and steps. model: the largest "
            "difference of the models that are exact for the case. domain: a finite block "
            "against the unbounded layer.",
        .columns = report::columns("quantity", "value", "bar [%]:2", "grid [%]:2", "model [%]:2",
                                   "domain [%]:2", "source")};
    for (const ComparedNumber& one : comparison.numbers) {
        if (one.is_norm) continue;
        const ReferenceValue& reference = one.reference;
        const double size = std::abs(reference.value);
        const auto part = [&](double bar) { return percent_cell_of(bar / size); };
        table.rows.push_back({one.title, value_of(one, reference.value), part(reference.bar()),
                              part(reference.grid), part(reference.model), part(reference.domain),
                              reference.source});
    }
    return table;
}

report::DocumentTable convention_table(const Comparison& comparison) {
    report::DocumentTable table{.id = "conventions_found",
                                .title = "Conventions found",
                                .columns = report::columns("of", "found", "number that decides"),
                                .stacks = true};
    for (const Convention& one : comparison.conventions)
        table.rows.push_back({one.id, one.choice, one.number});
    return table;
}

report::DocumentTable diagnosis_table(const Comparison& comparison) {
    report::DocumentTable table{.id = "diagnoses_made",
                                .title = "Diagnoses",
                                .columns = report::columns("id", "what the numbers show", "remedy"),
                                .stacks = true};
    for (const Diagnosis& one : comparison.diagnoses)
        table.rows.push_back({one.id, one.sentence, one.remedy});
    return table;
}

report::DocumentTable mesh_table(const Comparison& comparison) {
    report::DocumentTable table{
        .id = "meshes_read",
        .title = "Meshes, coarse to fine",
        .columns = report::columns("mesh", "file", "format", "points", "CPU time [s]:3"),
        .stacks = true};
    const auto& fields = comparison.submission.meshes;
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k) {
        const MeshResult& mesh = comparison.meshes[k];
        table.rows.push_back(
            {mesh_name(comparison, k), mesh.file, k < fields.size() ? fields[k].format : "",
             static_cast<int>(mesh.points.size()), report::number_cell(mesh.cpu_time)});
    }
    return table;
}

report::DocumentTable submission_table(const Comparison& comparison) {
    const Submission& s = comparison.submission;
    const ContactMethod& contact = s.contact;
    report::DocumentTable table{
        .id = "submission_given",
        .title = "The submission as given",
        .columns = report::columns("key", "value"),
        .rows = {{"code", s.code.empty() ? "not given" : s.code},
                 {"elements", s.elements.value_or("not given")},
                 {"contact method", words_of(contact.kind)},
                 {"normal stiffness", given(contact.stiffness, "Pa/m")},
                 {"stick slope", given(contact.stick_slope, "Pa/m")},
                 {"kinematics", words_of(contact.kinematics)},
                 {"steps of pressing",
                  contact.press_steps ? std::to_string(*contact.press_steps) : "not given"},
                 {"half width of the block", given(s.block_width, "m")},
                 {"tolerance", report::share(s.tolerances.usual)}}};
    for (const auto& [key, value] : s.tolerances.of)
        table.rows.push_back({"tolerance of " + key, report::share(value)});
    return table;
}

}  // namespace tricontact::benchmarks
