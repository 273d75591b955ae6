// A comparison as numbers: JSON and CSV.

#include "benchmarks/report/comparison_output.h"
#include "benchmarks/report/comparison_words.h"
#include "comparisons/quantities/quantities.h"
#include "io/keys/toml_document.h"
#include "report/csv.h"
#include "report/json_number.h"

namespace tricontact::benchmarks {

namespace {

using json = nlohmann::ordered_json;

json reference_json(const ReferenceValue& reference) {
    return {
        {"value", report::number(reference.value)},   {"bar", report::number(reference.bar())},
        {"grid", report::number(reference.grid)},     {"model", report::number(reference.model)},
        {"domain", report::number(reference.domain)}, {"source", reference.source}};
}

json explained_json(const Explained& one) {
    return {{"id", one.id},
            {"title", one.title},
            {"change", report::number(one.change)},
            {"bar", report::number(one.bar)}};
}

json limit_json(const std::optional<comparisons::LimitEstimate>& limit) {
    if (!limit) return nullptr;
    return {{"value", report::number(limit->value)},
            {"error_of_finest", report::number(limit->error)},
            {"order", report::number(limit->order)},
            {"convergence", comparisons::name_of(limit->convergence)}};
}

json number_json(const ComparedNumber& one) {
    return {{"title", one.title},
            {"unit", one.unit},
            {"is_norm", one.is_norm},
            {"verdict", name_of(one.standing)},
            {"verdict_unexplained", name_of(one.unexplained_standing)},
            {"difference", report::number(one.difference)},
            {"explained", report::number(one.explained_change())},
            {"left", report::number(one.left())},
            {"uncertainty", report::number(one.uncertainty)},
            {"tolerance", report::number(one.tolerance)},
            {"difference_of_finest", report::number(one.finest)},
            {"discretisation", report::number(one.discretisation)},
            {"explained_by", report::list_of(one.explained, explained_json)},
            {"values", report::numbers(one.values)},
            {"limit", limit_json(one.limit)},
            {"order", one.limit ? report::number(one.limit->order) : json()},
            {"expected_order", one.expected_order},
            {"reference", reference_json(one.reference)},
            {"blame", one.blame},
            {"remedy", one.remedy}};
}

json submission_json(const Submission& s) {
    json tolerances = json::object();
    for (const auto& [key, value] : s.tolerances.of) tolerances[key] = value;
    const ContactMethod& contact = s.contact;
    return {{"code", s.code},
            {"elements", s.elements},
            {"contact",
             {{"method", words_of(contact.kind)},
              {"kinematics", words_of(contact.kinematics)},
              {"stiffness_Pa_per_m", report::number(contact.stiffness)},
              {"stick_slope_Pa_per_m", report::number(contact.stick_slope)},
              {"press_steps", contact.press_steps}}},
            {"block_width_m", report::number(s.block_width)},
            {"tolerance", {{"default", s.tolerances.usual}, {"of", tolerances}}}};
}

json mesh_json(const Comparison& comparison, std::size_t k) {
    const MeshResult& mesh = comparison.meshes[k];
    json totals = json::object();
    for (const auto& [key, value] : mesh.totals) totals[key] = report::number(value);
    const auto& fields = comparison.submission.meshes;
    const bool is_read = k < fields.size();
    return {{"file", mesh.file},
            {"format", is_read ? fields[k].format : ""},
            {"size_m", report::number(mesh.size)},
            {"points", mesh.points.size()},
            {"faces", mesh.faces.size()},
            {"totals", totals},
            {"cpu_s", report::number(mesh.cpu_time)},
            {"notes", is_read ? fields[k].notes : std::vector<std::string>{}}};
}

json convention_json(const Convention& one) {
    return {{"id", one.id}, {"choice", one.choice}, {"number", one.number}};
}

json diagnosis_json(const Diagnosis& one) {
    return {{"id", one.id}, {"sentence", one.sentence}, {"remedy", one.remedy}};
}

}  // namespace

json comparison_json(const std::string& version, const Comparison& comparison) {
    json quantities = json::object(), meshes = json::array();
    for (const ComparedNumber& one : comparison.numbers) quantities[one.key] = number_json(one);
    for (std::size_t k = 0; k < comparison.meshes.size(); ++k)
        meshes.push_back(mesh_json(comparison, k));
    const Reference& reference = comparison.reference;
    return {
        {"version", version},
        {"problem", comparison.name},
        {"title", comparison.title},
        {"verdict", name_of(comparison.standing)},
        {"verdict_unexplained", name_of(comparison.unexplained_standing)},
        {"blame", comparison.blame},
        {"sentences", comparison.sentences},
        {"quantities", quantities},
        {"diagnoses", report::list_of(comparison.diagnoses, diagnosis_json)},
        {"conventions", report::list_of(comparison.conventions, convention_json)},
        {"meshes", meshes},
        {"is_family", comparison.is_family},
        {"submission", submission_json(comparison.submission)},
        {"reference",
         {{"digest", reference.digest},
          {comparisons::quantities::contact_radius.key, report::number(reference.contact_radius)},
          {"prescribed", reference.prescribed},
          {"models", reference.models},
          {"remarks", reference.remarks}}},
        {"case", io::case_json(case_text(comparison))}};
}

std::string comparison_csv(const Comparison& comparison) {
    std::string text = report::csv_line(
        {"quantity", "unit", "mesh", "file", "size_m", "value", "reference", "reference_bar",
         "difference", "explained", "uncertainty", "tolerance", "verdict", "verdict_unexplained"});
    for (const ComparedNumber& one : comparison.numbers)
        for (std::size_t k = 0; k < comparison.meshes.size(); ++k) {
            const MeshResult& mesh = comparison.meshes[k];
            const auto value = k < one.values.size() ? one.values[k] : std::nullopt;
            text += report::csv_row(one.key, one.unit, static_cast<double>(k + 1), mesh.file,
                                    mesh.size, value, one.reference.value, one.reference.bar(),
                                    difference_of(one, k), one.explained_change(), one.uncertainty,
                                    one.tolerance, name_of(one.standing),
                                    name_of(one.unexplained_standing));
        }
    return text;
}

}  // namespace tricontact::benchmarks
