#include "comparisons/shakedown/study_fit.h"

#include <nlohmann/json.hpp>

#include "comparisons/shakedown/fit_document.h"
#include "report/csv.h"
#include "report/json_table.h"

namespace tricontact::comparisons {

using json = nlohmann::ordered_json;

// What the library writes lists and optional values by.

static void to_json(json& out, const Computed& value) {
    out = {{"value", value.value}, {"numerical_error", value.error}};
}

static void to_json(json& out, const FittedForm& form) {
    json parameters = json::object();
    for (std::size_t k = 0; k < form.parameters.size(); ++k)
        parameters[form.parameters[k]] = form.fit.parameters[k];
    out = {{"form", form.form},
           {"parameters", parameters},
           {"explained_sum_of_squares", form.of_left_side.explained},
           {"residual_sum_of_squares", form.of_left_side.residual},
           {"r_squared", form.of_left_side.r_squared},
           {"r_squared_about_zero", form.fit.r_squared()},
           {"observations", form.fit.fitted.size()},
           {"degrees_of_freedom", form.fit.degrees_of_freedom}};
}

static void to_json(json& out, const RollingPoint& p) {
    out = {{"model", p.model},
           {"group", p.group},
           {quantities::amplitude_ratio.key, p.amplitude_ratio},
           {quantities::tangential_ratio.key, p.tangential_ratio},
           {quantities::state.key, contact::name_of(p.state)}};
    for (const Quantity* q : point_quantities) out[q->key] = p.find(*q) ? json(p.at(*q)) : json();
}

static void to_json(json& out, const MappingUse& use) {
    out = {{"name", use.name},
           {quantities::kappa.key, use.kappa},
           {"median_error", use.median},
           {"worst_error", use.worst},
           {"worst_amplitude_ratio", use.worst_amplitude_ratio},
           {"worst_tangential_ratio", use.worst_tangential_ratio},
           {"points", use.n},
           {"points_said_to_ratchet", use.n_ratcheting},
           {"points_with_numerical_error", use.n_with_bars},
           {"points_beyond_numerical_error", use.n_beyond_bars}};
}

static void to_json(json& out, const OneMapping& one) {
    const bool some = one.low <= one.high;
    out = {{"finding", report::word_of(one.finding)},
           {"kappa_low", some ? json(one.low) : json()},
           {"kappa_high", some ? json(one.high) : json()},
           {"points_with_numerical_error", one.n_with_bars},
           {"points_that_know_kappa_to_10_percent", one.n_telling},
           {"misses_less_than_0.1_percent", one.is_negligible}};
}

static void to_json(json& out, const MappingPoint& p) {
    out = {{quantities::amplitude_ratio.key, p.at.amplitude_ratio},
           {quantities::tangential_ratio.key, p.at.tangential_ratio},
           {"over_limit", p.limit_ratio},
           {quantities::kappa.key, p.kappa}};
}

static void to_json(json& out, const MappingGroup& group) {
    out = {{"model", group.model},
           {"group", group.group},
           {"points", group.points},
           {"one_kappa", group.one},
           {"constant", group.constant},
           {"plane", group.plane},
           {"settled_shifts_by_one_kappa", group.uses}};
}

static void to_json(json& out, const RatchetingPoint& p) {
    out = {{quantities::amplitude_ratio.key, p.at.amplitude_ratio},
           {quantities::tangential_ratio.key, p.at.tangential_ratio},
           {quantities::limit_amplitude_ratio.key, p.amplitude_limit},
           {quantities::eta.key, p.eta},
           {"thesis_increment_over_model", p.thesis_ratio}};
}

static void to_json(json& out, const RatchetingLoad& load) {
    out = {{quantities::tangential_ratio.key, load.tangential_ratio},
           {quantities::static_shift_ratio.key, load.static_shift_ratio},
           {quantities::limit_amplitude_ratio.key, load.amplitude_limit},
           {"slope", load.slope}};
}

static void to_json(json& out, const RatchetingGroup& group) {
    out = {{"model", group.model},
           {"group", group.group},
           {"limit", group.limit},
           {"points", group.points},
           {"loads", group.loads},
           {"root", group.root},
           {"root_of_eta", group.root_of_eta},
           {"points_by_turning_points_only", group.n_turning_points_only}};
}

static void to_json(json& out, const PointDifference& p) {
    out = {{quantities::amplitude_ratio.key, p.amplitude_ratio},
           {quantities::tangential_ratio.key, p.tangential_ratio},
           {"first", p.first},
           {"second", p.second},
           {"relative_difference", p.relative()},
           {"relative_error", p.bar()},
           {"differs", differs(p.first, p.second)}};
}

static void to_json(json& out, const ModelDifference& d) {
    out = {{"quantity", d.quantity->symbol},
           {"first", d.first},
           {"second", d.second},
           {"group", d.group},
           {"median_magnitude", d.median()},
           {"worst", d.worst().relative()},
           {"points_that_differ", d.n_different()},
           {"points", d.points}};
}

void evaluate(StudyFit& fit) {
    fit.mapping = mapping_fits(fit.points, fit.confidence, *fit.law);
    fit.ratcheting = ratcheting_fits(fit.points, fit.confidence, *fit.law);
    fit.differences = model_differences(fit.points);
}

std::string relaxing_caveat() {
    return "The substrate relaxes, while the formulas of kappa and eta are those of an elastic "
           "one: what is fitted belongs to this drive's speed and rest under load, part of each "
           "shift is creep, and the constants of the thesis are no reference for it";
}

std::string fit_json(const StudyFit& fit) {
    const json all = {{"tricontact", fit.version},
                      {"title", fit.title},
                      {"confidence", fit.confidence},
                      {"friction", fit.law->name},
                      {"caveat", fit.caveat.empty() ? json() : json(fit.caveat)},
                      {"points", fit.points},
                      {quantities::kappa.key, fit.mapping},
                      {quantities::eta.key, fit.ratcheting},
                      {"differences", fit.differences}};
    return all.dump(2) + '\n';
}

std::string points_csv(const StudyFit& fit) {
    std::vector<std::string> heading{"model", "group", quantities::amplitude_ratio.key,
                                     quantities::tangential_ratio.key, quantities::state.key};
    for (const Quantity* q : point_quantities)
        heading.insert(heading.end(), {q->key, std::string(q->key) + "_error"});
    heading.emplace_back("caveat");
    std::string text = report::csv_line(heading);
    for (const RollingPoint& p : fit.points) {
        std::vector<std::string> row{report::csv_field(p.model), report::csv_field(p.group),
                                     report::csv_field(p.amplitude_ratio),
                                     report::csv_field(p.tangential_ratio),
                                     contact::name_of(p.state)};
        for (const Quantity* q : point_quantities) {
            const Computed* value = p.find(*q);
            row.push_back(value ? report::csv_field(value->value) : "");
            row.push_back(value ? report::csv_field(value->error) : "");
        }
        row.push_back(report::csv_field(fit.caveat));
        text += report::csv_line(row);
    }
    return text;
}

std::string fits_csv(const StudyFit& fit) {
    std::string text = report::csv_line(
        {"model", "group", "form", "parameter", "value", "standard_error", "low", "high",
         "explained_sum_of_squares", "residual_sum_of_squares", "r_squared", "r_squared_about_zero",
         "observations", "degrees_of_freedom", "caveat"});
    for (const auto& rows : {mapping_rows(fit), ratcheting_rows(fit)})
        for (const auto& [model, group, form, k] : rows) {
            const statistics::Fit& f = form->fit;
            const statistics::Estimate& e = f.parameters[k];
            const Goodness& g = form->of_left_side;
            text += report::csv_row(model, group, form->form, form->parameters[k], e.value,
                                    e.standard_error, e.low, e.high, g.explained, g.residual,
                                    g.r_squared, f.r_squared(), std::to_string(f.fitted.size()),
                                    std::to_string(f.degrees_of_freedom), fit.caveat);
        }
    return text;
}

}  // namespace tricontact::comparisons
