#include "comparisons/run/report.h"

#include <algorithm>
#include <utility>

#include "comparisons/adhesion/force_curve.h"
#include "comparisons/bodies/body_deviation.h"
#include "comparisons/half_space/layer_report.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/results.h"
#include "comparisons/run/answer.h"
#include "comparisons/run/contact_film.h"
#include "comparisons/run/figures.h"
#include "comparisons/run/loading_reading.h"
#include "comparisons/run/path_section.h"
#include "comparisons/run/reading.h"
#include "comparisons/run/relaxation_report.h"
#include "comparisons/run/report_tables.h"
#include "report/document_csv.h"
#include "report/format.h"
#include "report/gnuplot_figure.h"

namespace tricontact::comparisons {

namespace {

using report::DocumentSection;

constexpr const char* audit_paragraph =
    "Every step of every model was checked; the table shows the worst violation of the whole run, "
    "dimensionless. A run with a failed check does not end normally.";

constexpr const char* sources =
    "Wetter (2016), The Interplay of System Dynamics and Dry Friction: Shakedown, Ratcheting and "
    "Micro-Walking (thesis, TU Berlin) · Mindlin and Deresiewicz (1953), J. Appl. Mech. 20 · "
    "Johnson (1985), Contact Mechanics";

DocumentSection results_section(const contact::Case& c, const std::vector<Results>& results,
                                const std::optional<NumericalError>& error) {
    DocumentSection section{.id = "results",
                            .heading = "Results",
                            .tables = results_tables(c, results, error),
                            .printed = true};
    if (std::ranges::any_of(results, [](const Results& s) { return s.periods() > 0; }))
        section.tables.push_back(period_table(results));
    return section;
}

/// Sections that only some cases have.
std::vector<DocumentSection> study_sections(const contact::Case& c,
                                            const std::vector<contact::History>& histories,
                                            const std::vector<Results>& results,
                                            const ReportExtras& extras) {
    using Tables = std::vector<report::DocumentTable>;
    std::vector<DocumentSection> sections;
    const auto add = [&](const char* id, const char* heading,
                         const std::vector<std::string>& sentences, const Tables& tables) {
        sections.push_back({id, heading, sentences, {}, tables});
    };
    if (const auto bodies = body_deviation(c, results, extras.study, errors_of(extras)))
        add("half_space_deviation", "Half-space deviation of the bodies",
            body_deviation_sentences(c, *bodies), {body_deviation_table(*bodies)});
    if (const auto layer = compare_with_layer(c, histories, extras.study))
        add("layer", "The layer", layer_sentences(c, *layer), {layer_table(c, *layer)});
    const auto& variants = extras.study.variants;
    if (c.layer.thickness || !variants.empty())
        add("loading", "Coupling and pressing", treatment_sentences(c, c.models, variants),
            variants.empty() ? Tables() : Tables{variants_table(variants)});
    if (c.relaxation && !c.prescribed_path)
        add("relaxation", "Relaxation", relaxation_sentences(c, extras.relaxation),
            extras.relaxation.twins.empty() ? Tables()
                                            : Tables{relaxation_table(c, extras.relaxation)});
    if (!extras.small_strains.empty()) {
        Tables tables;
        for (const SmallStrains& study : extras.small_strains)
            if (study.linear) tables.push_back(small_strain_table(study));
        add("small_strains", "Finite strains", small_strain_sentences(extras.small_strains),
            tables);
    }
    if (extras.refinement) {
        Tables tables{refinement_table(*extras.refinement)};
        if (!extras.refinement->fields.empty())
            tables.push_back(refined_fields_table(*extras.refinement));
        add("refinement", "Refinement", refinement_sentences(*extras.refinement), tables);
        sections.back().open = true;
    }
    return sections;
}

std::vector<std::pair<std::string, std::string>> files_of(const std::vector<Results>& results,
                                                          bool is_refinement) {
    if (is_refinement)
        return {{"resolved case", "case.toml"},
                {"values on all levels", "refinement.csv"},
                {"the same for scripts", "refinement.json"}};
    std::vector<std::pair<std::string, std::string>> files{
        {"resolved case", "case.toml"}, {"these numbers for scripts", "summary.json"}};
    for (const Results& s : results)
        files.emplace_back("every step of " + report::display_name(s.model),
                           s.model + "/history.csv");
    return files;
}

/// What a path with a closed cycle is asked for stands first, its shift among the path's figures.
void lead_with_loop(report::Document& document) {
    for (DocumentSection& section : document.sections)
        for (report::Figure& figure : section.figures)
            if (document.figure && figure.id.starts_with("path_loop")) {
                std::swap(*document.figure, figure);
                return;
            }
}

}  // namespace

std::vector<NumericalError> errors_of(const ReportExtras& extras) {
    std::vector<NumericalError> errors = extras.other_numerical;
    if (extras.numerical) errors.push_back(*extras.numerical);
    return errors;
}

report::Document run_document(const contact::Case& c, const std::string& resolved_case,
                              const std::string& version,
                              const std::vector<contact::History>& histories,
                              const ReportExtras& extras) {
    std::vector<Results> results;
    for (const contact::History& history : histories)
        results.push_back(results_beside(c, history, extras.study));
    report::Document document{.kind = "contact report",
                              .title = c.title.empty() ? "Frictional contact" : c.title,
                              .settings = settings_of(c),
                              .files = files_of(results, extras.refinement.has_value()),
                              .command = "tricontact run case.toml",
                              .version = version,
                              .input = resolved_case,
                              .plots = "plots"};
    document.answer = answer_of(c, results.back(), extras.numerical, extras.refinement);
    if (results.size() > 1) document.comparison = models_table(c, results, extras.numerical);
    document.verdicts_heading = "Assumptions";
    document.verdicts = assumption_verdicts(c, results, extras);
    document.player = player_of(c, extras.films);
    document.sections = {{"reading", "Reading", reading(c, results)},
                         results_section(c, results, extras.numerical)};
    if (c.prescribed_path) document.sections.push_back(path_section(c, histories));
    if (c.adhesion && c.adhesion->is_reversible() && c.prescribed_path)
        document.sections.push_back(
            {"jumps", "Jumps into contact and out of it", {}, {}, {jump_table(histories)}});
    for (DocumentSection& section : study_sections(c, histories, results, extras))
        document.sections.push_back(std::move(section));
    Figures figures = make_figures(c, histories, extras.numerical);
    if (!figures.empty()) {
        document.figure = std::move(figures.front());
        figures.erase(figures.begin());
    }
    if (results.back().number(quantities::loop_force)) lead_with_loop(document);
    if (c.relaxation)
        for (report::Figure& figure : modulus_figures(c, extras.relaxation))
            figures.push_back(std::move(figure));
    document.sections.insert(document.sections.end(), extras.sections.begin(),
                             extras.sections.end());
    document.sections.push_back({"plots", "Figures", {}, figures});
    document.sections.push_back({"derived_values", "Derived values", {}, {}, {derived_table(c)}});
    document.sections.push_back({"audit", "Audit", {audit_paragraph}, {}, {audit_table(results)}});
    document.sections.push_back({"sources", "Sources", {sources}});
    return document;
}

std::vector<ReportFile> report_files(const report::Document& document) {
    const std::vector<report::Figure> figures = report::figures_of(document);
    std::vector<ReportFile> files{{"report.html", report::document_html(document)}};
    const std::vector<report::Drawing> drawings = report::draw_all(figures);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const std::string name = document.plots + "/" + figures[i].id;
        files.push_back({name + ".svg", drawings[i].svg});
        if (report::has_png(figures[i])) files.push_back({name + ".png", drawings[i].png});
        files.push_back({name + ".csv", report::figure_csv(figures[i])});
    }
    return files;
}

}  // namespace tricontact::comparisons
