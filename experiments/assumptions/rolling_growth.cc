// What rolling adds to the shift: half-space or layer.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

double smallest_rolling_amplitude(const Rig& rig) {
    return number_of(rig, &Rig::W);
}

Assumption growth_by_rolling(const Rig& rig, const RolledGrowth& growth) {
    Assumption a{.name = "growth_by_rolling",
                 .title = "What rolling adds",
                 .claim = "Rolling adds to the shift on the layer what it adds on a half-space"};
    if (!rig.w.is_known()) {
        a.missing = {"rig.smallest_amplitude_ratio"};
        return a;
    }
    const auto found = growth && roller_is_rigid(rig) ? growth(rig) : std::nullopt;
    if (!found) {
        a.missing = {
            "maps of what rolling adds, on the layer and on a half-space, that reach to "
            "this rig"};
        return a;
    }
    a.criteria.push_back(
        {relative_difference(
             "growth_difference", "|g layer/g half-space - 1|",
             "g = U_sd/U_stat at half the layer's limit of shakedown and the least amplitude",
             "maps of boundary elements",
             {"g layer", {found->layer.value, found->layer.standard_error}, "1"},
             {"g half-space", {found->half_space.value, found->half_space.standard_error}, "1"}),
         Criterion::Relation::at_most, accepted_difference, accepted_reason});
    const double angle = rig.alpha.is_known() ? rig.alpha.value : 0;
    a.consequence = fmt::format(
        "Rolled by {} {} F_T = {} mu F_N, half the layer's limit of shakedown, the shift "
        "settles at {} times the static one on the layer and {} times on a half-space.",
        quantity(found->amplitude, "m", 3),
        angle == 0 ? "along"
                   : fmt::format("at {} deg to", significant(angle * 180 / std::numbers::pi, 3)),
        significant(found->tangential_ratio, 3), significant(found->layer.value, 4),
        significant(found->half_space.value, 4));
    return a;
}

}  // namespace tricontact::experiments
