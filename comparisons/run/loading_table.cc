#include "comparisons/run/loading_report.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using report::Cell;

/// `get`: the shift of an outcome [m]. Where the other has none to compare, its verdict stands in
/// the place of a number.
template <class Get>
std::vector<Cell> row(const LoadingVariant& v, const std::string& what, const Get& get,
                      std::optional<double> ratio, const std::string& other_verdict) {
    const report::Unit unit = report::fitting_unit(get(v.run), "m");
    Cell changed = report::number_cell({});
    if (!other_verdict.empty())
        changed = other_verdict;
    else if (v.other)
        changed = get(*v.other) / unit.factor;
    return {report::display_name(v.model) + ": " + what,
            v.key + ": " + v.changed + " instead of " + v.chosen,
            unit.symbol,
            get(v.run) / unit.factor,
            changed,
            report::number_cell(ratio ? std::optional(100 * (*ratio - 1)) : ratio)};
}

std::vector<Cell> static_row(const LoadingVariant& v) {
    return row(
        v, "static shift", [](const LoadingOutcome& outcome) { return outcome.static_shift; },
        v.static_ratio(), "");
}

std::string rolled_title(const LoadingVariant& v) {
    switch (*v.run.state) {
        case State::ratcheting:
            return "shift per period while ratcheting";
        case State::shakedown:
        case State::cyclic_slip:
            return "settled shift";
        default:
            return "shift after the last period";
    }
}

/// After rolling.
std::vector<Cell> rolled_row(const LoadingVariant& v) {
    const bool ratchets = *v.run.state == State::ratcheting;
    const bool differs = !v.rolled_ratio() && v.other && v.other->state;
    return row(
        v, rolled_title(v),
        [&](const LoadingOutcome& outcome) {
            return ratchets ? outcome.increment : outcome.final_shift;
        },
        v.rolled_ratio(), differs ? contact::name_of(*v.other->state) : "");
}

}  // namespace

report::DocumentTable variants_table(const std::vector<LoadingVariant>& variants) {
    report::DocumentTable table{.id = "variants",
                                .title = "Shift with one choice changed",
                                .columns = {{"quantity"},
                                            {"changed key"},
                                            {"unit"},
                                            {"this run"},
                                            {"changed"},
                                            {.heading = "difference [%]", .change = true}}};
    for (const LoadingVariant& v : variants) {
        table.rows.push_back(static_row(v));
        if (v.run.state) table.rows.push_back(rolled_row(v));
    }
    return table;
}

}  // namespace tricontact::comparisons
