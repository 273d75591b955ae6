#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/resolution/refinement.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// A field of the surface that is followed over meshes.
struct FieldKind {
    using Field = std::vector<double> contact::Surface::*;
    const char *field, *unit;         ///< "normal_traction", "Pa"
    std::array<Field, 3> components;  ///< the first `n_components` of them
    int n_components;
    double order_at_worst;  ///< that the error of the largest difference counts on
    const char* name;       ///< "pressure p"
};

/// Pressure, tangential traction, displacement.
std::span<const FieldKind> field_kinds();

/// What two surfaces differ by: at the worst point, and as a norm over that of the first.
struct FieldChange {
    double largest = 0;  ///< [Pa], [m]
    double l2 = 0;       ///< sqrt(∫ difference^2 dA / ∫ a^2 dA) [-]
};

/// On the finer of their grids; empty without one of them, where they are at different instants,
/// and where the field is nowhere.
std::optional<FieldChange> field_change(const std::optional<contact::Snapshot>& a,
                                        const std::optional<contact::Snapshot>& b,
                                        const FieldKind& kind);

/// From the last states of at least three levels, sizes decreasing; `wide` is beside the finest but
/// one. Half widths as those of runs (runs/field_bars.h): 1.25/(r^q - 1) times the last change, or
/// what the one before comes to by the order q, where that is more; r is the ratio of the last
/// sizes. Norms count q = 1, largest differences of tractions q = 1/2, of displacements 1.
std::vector<RefinedField> refined_fields(
    const std::vector<double>& sizes, const std::vector<std::optional<contact::Snapshot>>& levels,
    const std::optional<contact::Snapshot>& wide);

}  // namespace tricontact::comparisons
