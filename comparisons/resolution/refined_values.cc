#include "comparisons/resolution/refined_values.h"

#include <algorithm>
#include <cmath>

namespace tricontact::comparisons {

namespace {

/// A change of this many solver tolerances is not significant: shifts gather the errors of many
/// steps.
constexpr double noisy_tolerances = 10;

std::optional<double> exact_value(const PressedValues& exact, const Quantity& q) {
    for (const PressedQuantity& pressed : pressed_quantities())
        if (pressed.quantity == &q) return pressed.get(exact);
    return {};
}

}  // namespace

Refinement make_refinement(const RefinedLevels& levels) {
    Refinement result{.model = levels.model,
                      .key = levels.key,
                      .sizes = levels.sizes,
                      .cpu_s = levels.cpu_s,
                      .quantities = {},
                      .exact_name = levels.exact_name,
                      .wide_factor = levels.wide ? levels.wide_factor : 0};
    for (const Quantity* q : all_quantities()) {
        const bool unrolled = levels.values.front().periods() == 0;
        if (!q->is_refined || (unrolled && q->part == Part::rolled)) continue;
        RefinedQuantity refined{.quantity = q};
        for (const Results& values : levels.values)
            if (const auto value = values.told(*q)) refined.values.push_back(*value);
        if (refined.values.size() != levels.sizes.size()) continue;
        refined.limit =
            estimate_limit(levels.sizes, refined.values,
                           noisy_tolerances * levels.tolerance * std::abs(refined.values.back()));
        if (levels.exact) refined.exact = exact_value(*levels.exact, *q);
        if (levels.wide) refined.wide = levels.wide->number(*q);
        result.quantities.push_back(std::move(refined));
    }
    return result;
}

}  // namespace tricontact::comparisons
