#pragma once

#include <vector>

#include "comparisons/finite_strain/strain_runs.h"
#include "comparisons/finite_strain/strain_threshold.h"

namespace tricontact::comparisons {

/// Where the linear law is off, and by how much.
struct StrainDeviation {
    StrainContact contact;
    std::vector<StrainPair> pairs;  ///< of strain_points, in their order
    /// Change of the case's own deviation from its mesh and steps to finer ones; undefined where
    /// one of them is.
    ByQuantity<double> errors;
    std::size_t n_failed_runs = 0;
};

/// What both laws gave at each of strain_points(): two by two, linear first.
StrainDeviation strain_deviation(const StrainContact& contact,
                                 const std::vector<std::optional<Results>>& results);

/// What varies while the rest is that of the case.
enum class StrainAxis { normal_force, thickness, tangential_ratio };

/// The deviation of a quantity along an axis, in increasing order. The error is that at the case's
/// own point: how it depends on the mesh was looked at there alone.
std::vector<DeviationPoint> deviation_along(const StrainDeviation& deviation, const Quantity* q,
                                            StrainAxis axis);

/// One quantity at the case's own point.
struct StrainRow {
    const Quantity* quantity = nullptr;
    double linear = 0, finite = 0;  ///< SI
    double deviation = 0;           ///< linear over finite, minus 1
    std::optional<double> error = {};
    double largest_force = 0;  ///< [N] up to which it was looked for
    /// Normal forces [N] from which on it exceeds strain_tolerances; empty: too few points.
    std::array<std::optional<StrainThreshold>, strain_tolerances.size()> forces = {};
};

/// Of all quantities that both laws told.
std::vector<StrainRow> strain_rows(const StrainDeviation& deviation);

}  // namespace tricontact::comparisons
