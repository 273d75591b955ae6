#pragma once

#include <optional>
#include <vector>

#include "benchmarks/comparison/comparison.h"
#include "report/figure.h"

namespace tricontact::benchmarks {

/// The budget of a number as a waterfall: the code's difference, minus each effect that explains
/// part of it, what is left with U, over the band of the tolerance.
report::Figure budget_figure(const ComparedNumber& number);
/// What is left of each number with U, over its own tolerance.
report::Figure left_figure(const Comparison& comparison);
/// Differences over the size of elements, of quantities and of norms, with slopes of the expected
/// orders; none of one mesh.
std::vector<report::Figure> error_figures(const Comparison& comparison);

/// Pressure and traction of the meshes over the reference's with its bar, along the radius or along
/// x; none where the reference has no fields.
std::vector<report::Figure> profile_figures(const Comparison& comparison);
/// Load inside a distance over F_N, and its difference from the reference's.
std::vector<report::Figure> load_figures(const Comparison& comparison);
/// Differences of pressure and traction over the contact of the finest mesh in three dimensions,
/// code minus reference, over the reference's largest.
std::vector<report::Figure> difference_maps(const Comparison& comparison);

}  // namespace tricontact::benchmarks
