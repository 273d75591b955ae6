#include "runs/field_bars.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/differences/surface_difference.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::runs {

namespace {

using comparisons::FieldBar;
using contact::Surface;
using Field = std::vector<double> Surface::*;

constexpr double factor_without_coarsest = 3;  // Roache (1998), ch. 5
constexpr double quarter_steps = 4. / 3, wider_sides = 1.8;
constexpr double alike_phases = 1e-6;

struct FieldKind {
    const char *field, *unit;
    std::array<Field, 3> components;
    int n_components;
    double order_at_worst;  ///< of the largest difference
};
constexpr std::array kinds{
    FieldKind{"normal_traction", "Pa", {&Surface::normal_traction}, 1, .5},
    FieldKind{"tangential_traction",
              "Pa",
              {&Surface::tangential_traction_x, &Surface::tangential_traction_y},
              2,
              .5},
    FieldKind{"displacement",
              "m",
              {&Surface::displacement_x, &Surface::displacement_y, &Surface::displacement_z},
              3,
              1}};

/// What two surfaces differ by: at the worst point, and as a norm over that of the first.
struct FieldChange {
    double largest = 0, l2 = 0;
};

std::optional<FieldChange> change_of(const std::optional<contact::Snapshot>& a,
                                     const std::optional<contact::Snapshot>& b,
                                     const FieldKind& kind) {
    if (!a || !b || std::abs(a->phase - b->phase) > alike_phases) return {};
    const auto d = comparisons::difference_of(a->surface, b->surface);
    FieldChange change;
    double apart2 = 0, own2 = 0;
    for (std::size_t k = 0; k < d.size(); ++k) {
        double apart = 0, own = 0;
        for (int i = 0; i < kind.n_components; ++i) {
            const auto &of_a = d.a.*kind.components[i], &of_b = d.b.*kind.components[i];
            if (of_a.empty() || of_b.empty()) continue;
            if (!std::isfinite(of_a[k]) || !std::isfinite(of_b[k])) continue;  // beyond a surface
            apart = std::hypot(apart, of_a[k] - of_b[k]);
            own = std::hypot(own, of_a[k]);
        }
        change.largest = std::max(change.largest, apart);
        apart2 += apart * apart;
        own2 += own * own;
    }
    if (!(own2 > 0)) return {};
    change.l2 = std::sqrt(apart2 / own2);
    return change;
}

std::optional<FieldBar> bar_of(const LastSurfaces& last, const FieldKind& kind) {
    const auto fine = change_of(last.run, last.coarser, kind);
    if (!fine) return {};
    const auto coarse = change_of(last.coarser, last.coarsest, kind);
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
            if (const auto changed = change_of(last.coarser, *other, kind))
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
    for (const FieldKind& kind : kinds)
        if (auto bar = bar_of(last, kind)) bars.push_back(*bar);
    return bars;
}

}  // namespace tricontact::runs
