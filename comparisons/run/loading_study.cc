#include "comparisons/run/loading_study.h"

#include <cmath>

#include "comparisons/quantities/quantities.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using json = nlohmann::ordered_json;

std::optional<double> ratio(std::optional<double> changed, std::optional<double> chosen) {
    const double value = changed.value_or(0) / chosen.value_or(0);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

json change_json(std::optional<double> ratio) {
    return ratio ? json(*ratio - 1) : json();
}

json outcome_json(const RunValues& outcome) {
    return {
        {quantities::static_shift.key, outcome.static_shift},
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
            {"static_change", change_json(v.static_ratio())},
            {"rolled_change", change_json(v.rolled_ratio())},
            {"why_none", v.other ? json() : json(v.why_none)}};
}

}  // namespace

std::optional<double> LoadingVariant::static_ratio() const {
    return other ? ratio(other->static_shift, run.static_shift) : std::nullopt;
}

std::optional<double> LoadingVariant::rolled_ratio() const {
    if (!other || !other->state || !run.state) return {};
    const bool ratchets = *run.state == State::ratcheting;
    if (ratchets != (*other->state == State::ratcheting)) return {};
    return ratchets ? ratio(other->increment, run.increment)
                    : ratio(other->final_shift, run.final_shift);
}

json loading_json(const std::vector<LoadingVariant>& variants) {
    return report::list_of(variants, variant_json);
}

}  // namespace tricontact::comparisons
