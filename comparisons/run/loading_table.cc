#include "comparisons/run/loading_study.h"
#include "contact/special_values.h"
#include "contact/verdict.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using report::Cell;

/// A shift [m]. Where the other has none to compare, its verdict stands in the place of a number.
std::vector<Cell> row(const LoadingVariant& v, const std::string& what, double chosen,
                      std::optional<double> changed, std::optional<double> error,
                      const std::string& other_verdict = "") {
    const report::Unit unit = report::fitting_unit(chosen, "m");
    return {report::display_name(v.model) + ": " + what,
            v.key + ": " + v.changed + " instead of " + v.chosen,
            unit.symbol,
            chosen / unit.factor,
            other_verdict.empty() ? report::number_cell(changed, unit.factor) : other_verdict,
            100 * error.value_or(contact::undefined)};
}

std::string rolled_title(const LoadingVariant& v) {
    if (*v.run.state == State::ratcheting) return "shift per period while ratcheting";
    return contact::settles(*v.run.state) ? "settled shift" : "shift after the last period";
}

/// After rolling.
std::vector<Cell> rolled_row(const LoadingVariant& v) {
    const auto shift =
        *v.run.state == State::ratcheting ? &RunValues::increment : &RunValues::final_shift;
    const bool differs = !v.rolled_error() && v.other && v.other->state;
    return row(v, rolled_title(v), *(v.run.*shift), v.other ? (*v.other).*shift : std::nullopt,
               v.rolled_error(), differs ? contact::name_of(*v.other->state) : "");
}

}  // namespace

report::DocumentTable variants_table(const contact::Case& c,
                                     const std::vector<LoadingVariant>& variants) {
    report::DocumentTable table{
        .id = "variants",
        .title = "Shift with one choice changed",
        .note = variants_note(c),
        .columns = report::columns("quantity", "changed key", "unit", "this run", "changed")};
    table.columns.push_back({.heading = "difference [%]", .change = true});
    for (const LoadingVariant& v : variants) {
        table.rows.push_back(row(v, "static shift", v.run.static_shift,
                                 v.other ? std::optional(v.other->static_shift) : std::nullopt,
                                 v.static_error()));
        if (v.run.state) table.rows.push_back(rolled_row(v));
    }
    return table;
}

}  // namespace tricontact::comparisons
