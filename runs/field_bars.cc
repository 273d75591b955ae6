#include "runs/field_bars.h"

#include <algorithm>
#include <cmath>

#include "comparisons/differences/field_changes.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::runs {

namespace {

using comparisons::field_change;
using comparisons::FieldBar;
using comparisons::FieldChange;
using comparisons::FieldKind;

constexpr double factor_without_coarsest = 3;  // Roache (1998), ch. 5
constexpr double quarter_steps = 4. / 3, wider_sides = 1.8;

std::optional<FieldBar> bar_of(const LastSurfaces& last, const FieldKind& kind) {
    const auto fine = field_change(last.run, last.coarser, kind);
    if (!fine) return {};
    const auto coarse = field_change(last.coarser, last.coarsest, kind);
    const auto half_width = [&](double FieldChange::*norm, double order) {
        const double ratio = std::pow(2, order);
        double mesh = factor_without_coarsest * fine.value().*norm;
        if (coarse)
            mesh = comparisons::safety_factor *
                   std::max(fine.value().*norm, coarse.value().*norm / ratio);
        double width = mesh / (ratio - 1);
        for (const auto& [other, factor] :
             {std::pair(&last.long_steps, 1.), std::pair(&last.short_steps, quarter_steps),
              std::pair(&last.wide_block, wider_sides)})
            if (const auto changed = field_change(last.coarser, *other, kind))
                width += comparisons::safety_factor * factor * (changed.value().*norm);
        return width;
    };
    return FieldBar{.field = kind.field,
                    .unit = kind.unit,
                    .largest = half_width(&FieldChange::largest, kind.order_at_worst),
                    .l2 = half_width(&FieldChange::l2, 1)};
}

}  // namespace

std::optional<contact::Snapshot> last_snapshot(const contact::History& history) {
    return history.snapshots.empty() ? std::nullopt : std::optional(history.snapshots.back());
}

std::vector<FieldBar> field_bars(const LastSurfaces& last) {
    std::vector<FieldBar> bars;
    for (const FieldKind& kind : comparisons::field_kinds())
        if (auto bar = bar_of(last, kind)) bars.push_back(*bar);
    return bars;
}

}  // namespace tricontact::runs
