#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Stretches of a line that its points stand for: from half way to the neighbours.
struct LineCells {
    std::vector<double> low, high;  ///< per point, in the unit of the positions
};

/// `positions` in any order. The outermost points' stretches end at them, but for `from_axis`: then
/// the first begins at 0 where that is nearer than one and a half spacings. Points at one place
/// share its stretch: each has it, and the number of its sharers divides its weight.
LineCells line_cells(std::span<const double> positions, bool from_axis);

/// What a stretch weighs in an integral: the area of its ring, or its length.
inline double stretch_weight(double low, double high, bool is_ring) {
    return is_ring ? std::numbers::pi * (high - low) * (high + low) : high - low;
}

/// How many points stand at a point's place, itself included.
std::vector<int> sharers(std::span<const double> positions);

/// Areas that the points of faces stand for: integrals of the shape functions, so that the sum of
/// nodal values times areas is the integral of what is interpolated. Corners of quadratic
/// triangles have none, those of quadrilaterals with eight points a negative one. Lines are of unit
/// depth. Throws contact::InputError if a face has a number of points that no element has.
std::vector<double> face_areas(std::span<const double> x, std::span<const double> y,
                               const Faces& faces);

/// The same by positive numbers: each face divided equally among its points.
std::vector<double> lumped_areas(std::span<const double> x, std::span<const double> y,
                                 const Faces& faces);

/// Faces of scattered points: Delaunay's triangles; cells where the points lie on a grid of
/// straight lines. Empty of fewer than three points, or of points on one line.
Faces triangulated(std::span<const double> x, std::span<const double> y);

}  // namespace tricontact::benchmarks
