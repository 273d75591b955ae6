#include "comparisons/run/loading_study.h"

#include <cmath>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using json = nlohmann::ordered_json;

std::optional<double> ratio(double changed, double chosen) {
    if (chosen == 0 || !std::isfinite(changed / chosen)) return {};
    return changed / chosen;
}

json change_json(std::optional<double> ratio) {
    return ratio ? json(*ratio - 1) : json();
}

json outcome_json(const std::optional<LoadingOutcome>& outcome) {
    if (!outcome) return nullptr;
    const bool rolled = outcome->state.has_value();
    return {{quantities::static_shift.key, outcome->static_shift},
            {quantities::state.key, rolled ? json(contact::name_of(*outcome->state)) : json()},
            {quantities::final_shift.key, rolled ? json(outcome->final_shift) : json()},
            {quantities::shift_increment.key, rolled ? json(outcome->increment) : json()}};
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
    json result = json::array();
    for (const LoadingVariant& v : variants)
        result.push_back({{"model", v.model},
                          {"key", v.key},
                          {"chosen", v.chosen},
                          {"changed", v.changed},
                          {"run", outcome_json(v.run)},
                          {"other", outcome_json(v.other)},
                          {"static_change", change_json(v.static_ratio())},
                          {"rolled_change", change_json(v.rolled_ratio())},
                          {"why_none", v.other ? json() : json(v.why_none)}});
    return result;
}

}  // namespace tricontact::comparisons
