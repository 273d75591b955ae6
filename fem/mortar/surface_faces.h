#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/compliances/compliance.h"

namespace tricontact::fem {

/// A face of a contact surface seen along z: straight edges, nine nodes of a biquadratic
/// quadrilateral (corners, edges, centre).
struct SeenFace {
    std::array<contact::Vector2, 4> corners;  ///< counter-clockwise [m]
    std::array<int, 9> nodes;                 ///< numbers of the surface's points

    contact::Vector2 low() const;
    contact::Vector2 high() const;
    /// Longest edge [m].
    double longest_edge() const;
    /// Place (s, t) in the unit square of a point in or near the face; empty where there is none.
    std::optional<contact::Vector2> place_of(const contact::Vector2& x) const;
};

/// Values of the nine functions at (s, t) of the unit square, in the order of the nodes.
std::array<double, 9> biquadratic(double s, double t);

/// The faces of a surface, `points.quads`. Throws contact::InputError where one is turned away from
/// z or has a corner of more than 180 degrees.
std::vector<SeenFace> seen_faces(const contact::ContactPoints& surface);

}  // namespace tricontact::fem
