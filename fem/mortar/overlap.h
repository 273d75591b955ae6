#pragma once

#include <functional>
#include <vector>

#include "contact/base/vector2.h"
#include "fem/mortar/pressure_grid.h"
#include "fem/mortar/surface_faces.h"

namespace tricontact::fem {

/// Receives a point [m] and its weight [m^2].
using AtPoint = std::function<void(const contact::Vector2& x, double weight)>;

/// Gauss points of what a face and a rectangle share, exact to degree 8: products of functions on a
/// parallelogram with bilinear ones have 6.
void integrate_shared(const SeenFace& face, const Rectangle& rectangle, const AtPoint& at);

/// Area that they share [m^2].
double shared_area(const SeenFace& face, const Rectangle& rectangle);

}  // namespace tricontact::fem
