#pragma once

#include <functional>

#include "fem/planar/mesh.h"

// Half sections x >= 0 of the bodies of two-body problems, symmetric about x = 0, with a uniform
// mesh where they touch, graded outwards. Lengths in m.

namespace tricontact::fem::planar {

/// Elements of the contact patch 0 <= x <= n size, and of what lies beyond.
struct Sizes {
    int n = 1;            ///< elements across the patch
    double size = 0;      ///< their length; nodes are half as far apart
    double growth = 1.2;  ///< of neighbouring elements outside, and in depth
    int n_deep = 4;       ///< elements of that size in depth

    double patch() const { return n * size; }
    /// Elements of half the size, whose growth over a length is the same.
    Sizes halved() const;
};

/// Layer or block below z = 0, its base held: width from the middle to the side, thickness.
Mesh layer_section(const Sizes& sizes, double half_width, double thickness);

/// Block that presses, its upper face held; `profile`: height of its lower face over z = 0 [m],
/// finite over the whole width.
Mesh block_section(const Sizes& sizes, double half_width, double height,
                   const std::function<double(double)>& profile);

/// Lower half of a ball or a cylinder, its flat face held.
Mesh half_disc_section(const Sizes& sizes, double radius);

/// Ball or cylinder on a hub, which is held.
Mesh disc_section(const Sizes& sizes, double radius, double hub_radius);

/// The same, its patch uniform in the angle instead of x: for a hole.
Mesh pin_section(const Sizes& sizes, double radius, double hub_radius);

/// Plate about a hole, its outer edge, a circle, held. The hole touches at its lowest point.
Mesh hole_section(const Sizes& sizes, double radius, double outer_radius);

}  // namespace tricontact::fem::planar
