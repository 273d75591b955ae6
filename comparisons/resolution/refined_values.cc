#include "comparisons/resolution/refined_values.h"

#include <algorithm>

#include "comparisons/resolution/numerical_error.h"
#include "contact/models/model_kind.h"

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

bool has_order(const RefinedLevels& levels, const Quantity& q) {
    return contact::model_kind(levels.model).converges_in_order && !q.is_counted;
}

/// Frictional work is of the first order at most: slip grows from the edge of the contact inwards.
constexpr double order_of_work = 1;

/// What the spread of three values counts where none has an order that can be relied on.
constexpr double of_spread = 2;

/// With an order where there is one. The contact ends anywhere between two cells, by which an order
/// is seen by accident: no error is less than the spread of the last three values. Of what is drawn
/// at random (random_refinements) 95 % are off by less.
LimitEstimate limit_of(const RefinedLevels& levels, const Quantity& q,
                       std::span<const double> values) {
    const double noise = noisy_tolerances * levels.tolerance * error_scale(q, levels.values.back());
    if (!has_order(levels, q)) return estimate_unordered(values, noise);
    LimitEstimate limit = estimate_limit(levels.sizes, values, noise,
                                         is_work(q) ? order_of_work : largest_trusted_order);
    const double spread = estimate_unordered(values).error / safety_factor;
    if (limit.convergence != Convergence::unchanged)
        limit.error = std::max(
            limit.error, limit.convergence == Convergence::ordered ? spread : of_spread * spread);
    return limit;
}

}  // namespace

Refinement make_refinement(const RefinedLevels& levels) {
    Refinement result{levels, {}, {}};
    if (!levels.wide) result.wide_factor = 0;
    for (const Quantity* q : all_quantities()) {
        // Without rolling the final shift is the static one, which a path does not have.
        const bool unrolled = levels.values.front().periods() == 0 &&
                              levels.values.front().told(quantities::static_shift);
        if (!q->is_refined || (unrolled && q->part == Part::rolled)) continue;
        if (levels.infinite_pressure && q == &quantities::peak_pressure) continue;
        RefinedQuantity refined{.quantity = q};
        for (const Results& values : levels.values)
            if (const auto value = values.told(*q)) refined.values.push_back(*value);
        if (refined.values.size() != levels.sizes.size()) continue;
        refined.limit = limit_of(levels, *q, refined.values);
        refined.limit.error =
            std::max(refined.limit.error,
                     least_area_error(*q, levels.values.back(), levels.model, levels.sizes.back()));
        if (levels.exact) refined.exact = exact_value(*levels.exact, *q);
        if (levels.wide) refined.wide = levels.wide->number(*q);
        result.quantities.push_back(std::move(refined));
    }
    return result;
}

}  // namespace tricontact::comparisons
