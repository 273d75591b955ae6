#include "comparisons/differences/field_changes.h"

#include <algorithm>
#include <cmath>

#include "comparisons/differences/surface_difference.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::comparisons {

namespace {

using contact::Snapshot;
using contact::Surface;

constexpr double alike_phases = 1e-6;
constexpr double order_of_norms = 1;

constexpr std::array kinds_of_fields{
    FieldKind{"normal_traction", "Pa", {&Surface::normal_traction}, 1, .5, "pressure p"},
    FieldKind{"tangential_traction",
              "Pa",
              {&Surface::tangential_traction_x, &Surface::tangential_traction_y},
              2,
              .5,
              "tangential traction τ"},
    FieldKind{"displacement",
              "m",
              {&Surface::displacement_x, &Surface::displacement_y, &Surface::displacement_z},
              3,
              1,
              "displacement u of the surface"}};

/// Of the finer of two levels whose sizes have the ratio r, h/h_fine, `before` being the change
/// before the last one, over sizes of the ratio r_before.
double error_of_changes(double last, double before, double r, double r_before, double order) {
    return safety_factor * std::max(last, before / std::pow(r_before, order)) /
           (std::pow(r, order) - 1);
}

}  // namespace

std::span<const FieldKind> field_kinds() {
    return kinds_of_fields;
}

std::optional<FieldChange> field_change(const std::optional<Snapshot>& a,
                                        const std::optional<Snapshot>& b, const FieldKind& kind) {
    if (!a || !b || std::abs(a->phase - b->phase) > alike_phases) return {};
    const auto d = difference_of(a->surface, b->surface);
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

std::vector<RefinedField> refined_fields(const std::vector<double>& sizes,
                                         const std::vector<std::optional<Snapshot>>& levels,
                                         const std::optional<Snapshot>& wide) {
    const std::size_t n = levels.size();
    std::vector<RefinedField> fields;
    if (n < 3 || sizes.size() != n) return fields;
    const double r = sizes[n - 2] / sizes[n - 1], r_before = sizes[n - 3] / sizes[n - 2];
    for (const FieldKind& kind : field_kinds()) {
        std::vector<FieldChange> changes;
        RefinedField one{kind.field, kind.unit, kind.name, {}, {}};
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const auto change = field_change(levels[k + 1], levels[k], kind);
            if (!change) break;
            changes.push_back(*change);
            one.changes.push_back(change->l2);
        }
        if (changes.size() + 1 != n) continue;
        const FieldChange &last = changes[n - 2], &before = changes[n - 3];
        if (last.l2 > 0 && before.l2 > last.l2)
            one.order = std::log(before.l2 / last.l2) / std::log(r_before);
        one.error_l2 = error_of_changes(last.l2, before.l2, r, r_before, order_of_norms);
        one.error_largest =
            error_of_changes(last.largest, before.largest, r, r_before, kind.order_at_worst);
        if (const auto change = field_change(levels[n - 2], wide, kind)) one.wide = change->l2;
        fields.push_back(std::move(one));
    }
    return fields;
}

}  // namespace tricontact::comparisons
