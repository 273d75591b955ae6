#pragma once

#include <numbers>

#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// A row of points without a length along y is the radius of a contact of revolution, from the axis
/// outwards.
inline bool are_radii(const ContactPoints& points) {
    return points.n_x > 0 && points.n_y == 1 && points.line_length == 0;
}

/// Of the ring that a point of these stands for, in spacings: nodes of quadratic elements have
/// Simpson's weights, 2/3 and 4/3.
inline double ring_width(const ContactPoints& points, std::size_t i) {
    return points.area[i] / (2 * std::numbers::pi * points.x[i] * points.spacing[0]);
}

}  // namespace tricontact::contact
