#pragma once

#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

/// Key of the patch test's norm.
inline constexpr const char* pressure_deviation = "pressure_deviation";

/// Compares with a closed form that every mesh has to meet: no limit is taken and no order is
/// expected, the mesh that is furthest off decides.
///
/// The patch test: "pressure_deviation", the largest |p - mean|/mean over the points, whose
/// tolerance is a tenth of the usual one, peak_pressure, normal_force and displacement. Throws
/// contact::InputError where a mesh has no pressures, or nodal forces in their place.
Comparison compare_patch_test(Submission submission);

/// The wedge: force_ratio, as stated or |tangential_force/normal_force|. Throws
/// contact::InputError where a mesh states neither.
Comparison compare_wedge(Submission submission);

}  // namespace tricontact::benchmarks
