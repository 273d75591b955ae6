#include "experiments/assumptions/assumption.h"

#include <algorithm>
#include <cmath>

namespace tricontact::experiments {

Standing Criterion::standing() const {
    const auto [value, error] = calculation.result;
    if (std::abs(value - threshold) < error) return Standing::cannot_tell;
    const bool holds = relation == Relation::at_most ? value <= threshold : value >= threshold;
    return holds ? Standing::holds : Standing::fails;
}

Standing Assumption::standing() const {
    const auto any = [&](Standing standing) {
        return std::ranges::any_of(criteria,
                                   [&](const auto& one) { return one.standing() == standing; });
    };
    if (any(Standing::fails)) return Standing::fails;
    const bool open = criteria.empty() || !missing.empty() || any(Standing::cannot_tell);
    return open ? Standing::cannot_tell : Standing::holds;
}

}  // namespace tricontact::experiments
