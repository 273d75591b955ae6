#include "comparisons/run/loading_study.h"

#include "comparisons/quantities/quantities.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using json = nlohmann::ordered_json;

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
            {"static_change", v.static_error()},
            {"rolled_change", v.rolled_error()},
            {"why_none", v.other ? json() : json(v.why_none)}};
}

}  // namespace

std::optional<double> LoadingVariant::rolled_error() const {
    const bool ratchets = run.state == State::ratcheting;
    if (!other || !other->state || !run.state || ratchets != (other->state == State::ratcheting))
        return {};
    return ratchets ? increment_error() : final_error();
}

json loading_json(const std::vector<LoadingVariant>& variants) {
    return report::list_of(variants, variant_json);
}

}  // namespace tricontact::comparisons
