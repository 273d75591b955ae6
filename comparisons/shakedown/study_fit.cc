#include "comparisons/shakedown/study_fit.h"

#include <nlohmann/json.hpp>

#include "comparisons/shakedown/fit_rows.h"
#include "report/csv.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

json computed(const Computed& value) {
    return {{"value", report::number(value.value)},
            {"numerical_error", report::number(value.error)}};
}

json form_json(const std::optional<FittedForm>& form) {
    if (!form) return nullptr;
    json parameters = json::object();
    for (std::size_t k = 0; k < form->parameters.size(); ++k) {
        const statistics::Estimate& e = form->fit.parameters[k];
        parameters[form->parameters[k]] = {{"value", report::number(e.value)},
                                           {"standard_error", report::number(e.standard_error)},
                                           {"low", report::number(e.low)},
                                           {"high", report::number(e.high)}};
    }
    return {{"form", form->form},
            {"parameters", parameters},
            {"explained_sum_of_squares", report::number(form->of_left_side.explained)},
            {"residual_sum_of_squares", report::number(form->of_left_side.residual)},
            {"r_squared", report::number(form->of_left_side.r_squared)},
            {"r_squared_about_zero", report::number(form->fit.r_squared())},
            {"observations", form->fit.fitted.size()},
            {"degrees_of_freedom", form->fit.degrees_of_freedom}};
}

json points_json(const std::vector<RollingPoint>& points) {
    json all = json::array();
    for (const RollingPoint& p : points) {
        json point{{"model", p.model},
                   {"group", p.group},
                   {quantities::amplitude_ratio.key, report::number(p.amplitude_ratio)},
                   {quantities::tangential_ratio.key, report::number(p.tangential_ratio)},
                   {quantities::state.key, contact::name_of(p.state)}};
        for (const Quantity* q : point_quantities())
            point[q->key] = p.find(*q) ? computed(p.at(*q)) : json();
        all.push_back(point);
    }
    return all;
}

json uses_json(const std::vector<MappingUse>& uses) {
    json all = json::array();
    for (const MappingUse& use : uses)
        all.push_back({{"name", use.name},
                       {quantities::kappa.key, report::number(use.kappa)},
                       {"median_error", report::number(use.median)},
                       {"worst_error", report::number(use.worst)},
                       {"worst_amplitude_ratio", report::number(use.worst_amplitude_ratio)},
                       {"worst_tangential_ratio", report::number(use.worst_tangential_ratio)},
                       {"points", use.n},
                       {"points_said_to_ratchet", use.n_ratcheting},
                       {"points_with_numerical_error", use.n_with_bars},
                       {"points_beyond_numerical_error", use.n_beyond_bars}});
    return all;
}

json one_json(const OneMapping& one) {
    static constexpr const char* names[] = {"holds", "fails", "cannot tell"};
    const bool some = one.low <= one.high;
    return {{"finding", names[static_cast<int>(one.finding)]},
            {"kappa_low", some ? report::number(one.low) : json()},
            {"kappa_high", some ? report::number(one.high) : json()},
            {"points_with_numerical_error", one.n_with_bars},
            {"points_that_know_kappa_to_10_percent", one.n_telling},
            {"misses_less_than_0.1_percent", one.is_negligible}};
}

json mapping_json(const std::vector<MappingGroup>& groups) {
    json all = json::array();
    for (const MappingGroup& group : groups) {
        json points = json::array();
        for (const MappingPoint& p : group.points)
            points.push_back(
                {{quantities::amplitude_ratio.key, report::number(p.at.amplitude_ratio)},
                 {quantities::tangential_ratio.key, report::number(p.at.tangential_ratio)},
                 {"over_limit", report::number(p.limit_ratio)},
                 {quantities::kappa.key, computed(p.kappa)}});
        all.push_back({{"model", group.model},
                       {"group", group.group},
                       {"points", points},
                       {"one_kappa", one_json(group.one)},
                       {"constant", form_json(group.constant)},
                       {"plane", form_json(group.plane)},
                       {"settled_shifts_by_one_kappa", uses_json(group.uses)}});
    }
    return all;
}

json ratcheting_json(const std::vector<RatchetingGroup>& groups) {
    json all = json::array();
    for (const RatchetingGroup& group : groups) {
        json points = json::array(), loads = json::array();
        for (std::size_t i = 0; i < group.points.size(); ++i) {
            const RatchetingPoint& p = group.points[i];
            points.push_back(
                {{quantities::amplitude_ratio.key, report::number(p.at.amplitude_ratio)},
                 {quantities::tangential_ratio.key, report::number(p.at.tangential_ratio)},
                 {quantities::limit_amplitude_ratio.key, computed(p.amplitude_limit)},
                 {quantities::eta.key, computed(p.eta)},
                 {"thesis_increment_over_model", report::number(group.thesis_ratio[i])}});
        }
        for (const RatchetingLoad& load : group.loads)
            loads.push_back(
                {{quantities::tangential_ratio.key, report::number(load.tangential_ratio)},
                 {quantities::static_shift_ratio.key, report::number(load.static_shift_ratio)},
                 {quantities::limit_amplitude_ratio.key, computed(load.amplitude_limit)},
                 {"slope", form_json(load.slope)}});
        all.push_back({{"model", group.model},
                       {"group", group.group},
                       {"limit", form_json(group.limit)},
                       {"points", points},
                       {"loads", loads},
                       {"root", form_json(group.root)},
                       {"root_of_eta", form_json(group.root_of_eta)},
                       {"points_by_turning_points_only", group.n_turning_points_only}});
    }
    return all;
}

json differences_json(const std::vector<ModelDifference>& differences) {
    json all = json::array();
    for (const ModelDifference& d : differences) {
        json points = json::array();
        for (const PointDifference& p : d.points)
            points.push_back(
                {{quantities::amplitude_ratio.key, report::number(p.amplitude_ratio)},
                 {quantities::tangential_ratio.key, report::number(p.tangential_ratio)},
                 {"first", computed(p.first)},
                 {"second", computed(p.second)},
                 {"relative_difference", report::number(p.relative())},
                 {"relative_error", report::number(p.bar())},
                 {"differs", differs(p.first, p.second)}});
        all.push_back({{"quantity", d.quantity->symbol},
                       {"first", d.first},
                       {"second", d.second},
                       {"group", d.group},
                       {"median_magnitude", report::number(d.median())},
                       {"worst", report::number(d.worst().relative())},
                       {"points_that_differ", d.n_different()},
                       {"points", points}});
    }
    return all;
}

}  // namespace

void evaluate(StudyFit& fit) {
    fit.mapping = mapping_fits(fit.points, fit.confidence);
    fit.ratcheting = ratcheting_fits(fit.points, fit.confidence);
    fit.differences = model_differences(fit.points);
}

std::string relaxing_caveat() {
    return "The substrate relaxes, while the formulas of kappa and eta are those of an elastic "
           "one: "
           "what is fitted belongs to this drive's speed and rest under load, part of each shift "
           "is "
           "creep, and the constants of the thesis are no reference for it";
}

std::string fit_json(const StudyFit& fit) {
    const json all = {{"tricontact", fit.version},
                      {"title", fit.title},
                      {"confidence", fit.confidence},
                      {"caveat", fit.caveat.empty() ? json() : json(fit.caveat)},
                      {"points", points_json(fit.points)},
                      {quantities::kappa.key, mapping_json(fit.mapping)},
                      {quantities::eta.key, ratcheting_json(fit.ratcheting)},
                      {"differences", differences_json(fit.differences)}};
    return all.dump(2) + '\n';
}

std::string points_csv(const StudyFit& fit) {
    std::vector<std::string> heading{"model", "group", quantities::amplitude_ratio.key,
                                     quantities::tangential_ratio.key, quantities::state.key};
    for (const Quantity* q : point_quantities())
        heading.insert(heading.end(), {q->key, std::string(q->key) + "_error"});
    heading.emplace_back("caveat");
    std::string text = report::csv_line(heading);
    for (const RollingPoint& p : fit.points) {
        std::vector<std::string> row{report::csv_field(p.model), report::csv_field(p.group),
                                     report::csv_field(p.amplitude_ratio),
                                     report::csv_field(p.tangential_ratio),
                                     contact::name_of(p.state)};
        for (const Quantity* q : point_quantities()) {
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
    for (const FitRow& row : fit_rows(fit))
        for (std::size_t k = 0; k < row.form->parameters.size(); ++k) {
            const statistics::Fit& f = row.form->fit;
            const statistics::Estimate& e = f.parameters[k];
            const Goodness& g = row.form->of_left_side;
            text += report::csv_line(
                {report::csv_field(row.model), report::csv_field(row.group),
                 report::csv_field(row.form->form), report::csv_field(row.form->parameters[k]),
                 report::csv_field(e.value), report::csv_field(e.standard_error),
                 report::csv_field(e.low), report::csv_field(e.high),
                 report::csv_field(g.explained), report::csv_field(g.residual),
                 report::csv_field(g.r_squared), report::csv_field(f.r_squared()),
                 std::to_string(f.fitted.size()), std::to_string(f.degrees_of_freedom),
                 report::csv_field(fit.caveat)});
        }
    return text;
}

}  // namespace tricontact::comparisons
