#include <cmath>

#include "comparisons/run/loading_report.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::State;

Table::Row row(const LoadingVariant& v, double chosen, const std::string& changed,
               const report::Unit& unit, std::optional<double> ratio) {
    return {v.key + ": " + v.changed + " instead of " + v.chosen,
            unit.symbol,
            {report::significant(chosen / unit.factor), changed, report::percent(ratio)}};
}

Table::Row static_row(const LoadingVariant& v) {
    const report::Unit unit = report::fitting_unit(v.run.static_shift, "m");
    const std::string changed = v.other ? report::significant(v.other->static_shift / unit.factor)
                                        : report::significant({});
    return row(v, v.run.static_shift, changed, unit, v.static_ratio());
}

/// After rolling; where the verdicts differ, the other one stands in the place of a number.
Table::Row rolled_row(const LoadingVariant& v) {
    const bool ratchets = *v.run.state == State::ratcheting;
    const auto shift = [&](const LoadingOutcome& outcome) {
        return ratchets ? outcome.increment : outcome.final_shift;
    };
    const report::Unit unit = report::fitting_unit(shift(v.run), "m");
    std::string changed = report::significant({});
    if (v.rolled_ratio())
        changed = report::significant(shift(*v.other) / unit.factor);
    else if (v.other && v.other->state)
        changed = contact::name_of(*v.other->state);
    return row(v, shift(v.run), changed, unit, v.rolled_ratio());
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

/// The group of that title, made if need be.
Table::Group& group_of(Table& table, const std::string& title) {
    for (Table::Group& group : table.groups)
        if (group.title == title) return group;
    return table.groups.emplace_back(Table::Group{title, {}});
}

}  // namespace

Table variants_table(const std::vector<LoadingVariant>& variants) {
    Table table{"Shift with one choice changed", {"this run", "changed", "difference"}, {}};
    for (const LoadingVariant& v : variants) {
        const std::string model = report::display_name(v.model) + ": ";
        group_of(table, model + "static shift").rows.push_back(static_row(v));
        if (v.run.state) group_of(table, model + rolled_title(v)).rows.push_back(rolled_row(v));
    }
    return table;
}

}  // namespace tricontact::comparisons
