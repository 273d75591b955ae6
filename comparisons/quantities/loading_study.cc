#include "comparisons/quantities/loading_study.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "contact/base/special_values.h"
#include "contact/verdict.h"
#include "report/format.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using report::Cell;
using json = nlohmann::ordered_json;

json outcome_json(const RunValues& outcome) {
    return {
        {quantities::static_shift.key, outcome.static_shift},
        {quantities::end_normal_force.key, outcome.normal_force},
        {quantities::end_indentation.key, outcome.indentation},
        {quantities::state.key, outcome.state ? json(contact::name_of(*outcome.state)) : json()},
        {quantities::final_shift.key, outcome.final_shift},
        {quantities::shift_increment.key, outcome.increment}};
}

json variant_json(const LoadingVariant& v) {
    return {{"model", v.model},
            {"key", v.key},
            {"chosen", v.chosen},
            {"changed", v.changed},
            {"run", outcome_json(v.run)},
            {"other", v.other ? outcome_json(*v.other) : json()},
            {"loaded_quantity", v.loaded->key},
            {"loaded_change", v.loaded_error()},
            {"rolled_change", v.rolled_error()},
            {"why_none", v.other ? json() : json(v.why_none)},
            {"why_not_rolled", v.why_not_rolled.empty() ? json() : json(v.why_not_rolled)}};
}

/// Where the other has nothing to compare, its verdict stands instead of a number. `quantity`: its
/// unit is that of the values.
std::vector<Cell> row(const LoadingVariant& v, const std::string& what, const Quantity& quantity,
                      double chosen, std::optional<double> changed, std::optional<double> error,
                      const std::string& other_verdict = "") {
    const report::Unit unit = report::fitting_unit(chosen, quantity.unit);
    return {report::display_name(v.model) + ": " + what,
            v.key + ": " + v.changed + " instead of " + v.chosen,
            unit.symbol,
            chosen / unit.factor,
            other_verdict.empty() ? report::number_cell(changed, unit.factor) : other_verdict,
            100 * error.value_or(contact::undefined)};
}

}  // namespace

Results results_beside(const contact::Case& c, const contact::History& history,
                       const LoadingStudy& study) {
    Results results(c, history);
    if (const auto found = study.normal_stiffness.find(history.model);
        found != study.normal_stiffness.end())
        results.set(quantities::normal_stiffness, finite(found->second));
    if (const auto found = study.upper_contact.find(history.model);
        found != study.upper_contact.end()) {
        const contact::Scales& upper = found->second;
        results.set(quantities::upper_indentation, finite(upper.indentation));
        results.set(quantities::upper_contact_radius, finite(upper.contact_radius));
        results.set(quantities::upper_peak_pressure, finite(upper.peak_pressure));
    }
    return results;
}

const Quantity& not_prescribed(const contact::Case& c) {
    return c.load.indentation ? quantities::end_normal_force : quantities::end_indentation;
}

double LoadingVariant::loaded_value(const RunValues& of) const {
    if (loaded == &quantities::end_normal_force) return of.normal_force;
    return loaded == &quantities::end_indentation ? of.indentation : of.static_shift;
}

std::optional<double> LoadingVariant::loaded_error() const {
    return other ? relative_error(loaded_value(*other), loaded_value(run)) : std::nullopt;
}

std::optional<double> LoadingVariant::rolled_error() const {
    const bool ratchets = run.state == State::ratcheting;
    if (!other || !other->state || !run.state || ratchets != (other->state == State::ratcheting))
        return {};
    return ratchets ? increment_error() : final_error();
}

json loading_json(const std::vector<LoadingVariant>& variants) {
    return report::list_of(variants, variant_json);
}

report::DocumentTable variants_table(const std::vector<LoadingVariant>& variants) {
    const bool rolls = std::ranges::any_of(
        variants, [](const LoadingVariant& v) { return v.run.state.has_value(); });
    report::DocumentTable table{
        .id = "variants",
        .title = "With one choice changed",
        .note = std::string("Each row loads the case once more with one key changed.") +
                (rolls ? " Contacts that shake down are rolled by turning points until nothing "
                         "moves, or 40 periods, “this run” too, so that its value may differ from "
                         "that of the case's own steps and periods; what ratchets is rolled as the "
                         "case has it."
                       : ""),
        .columns = report::columns("quantity", "changed key", "unit", "this run", "changed")};
    table.columns.push_back({.heading = "difference [%]", .change = true});
    for (const LoadingVariant& v : variants) {
        table.rows.push_back(row(v, v.loaded->name, *v.loaded, v.loaded_value(v.run),
                                 v.other ? std::optional(v.loaded_value(*v.other)) : std::nullopt,
                                 v.loaded_error()));
        if (!v.run.state) continue;
        const bool ratchets = *v.run.state == State::ratcheting;
        const auto shift = ratchets ? &RunValues::increment : &RunValues::final_shift;
        const char* const title = ratchets ? "shift per period while ratcheting"
                                  : contact::settles(*v.run.state) ? "settled shift"
                                                                   : "shift after the last period";
        const bool differs = !v.rolled_error() && v.other && v.other->state;
        table.rows.push_back(row(v, title, quantities::final_shift, *(v.run.*shift),
                                 v.other ? (*v.other).*shift : std::nullopt, v.rolled_error(),
                                 differs ? contact::name_of(*v.other->state) : ""));
    }
    return table;
}

}  // namespace tricontact::comparisons
