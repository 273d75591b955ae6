#pragma once

#include <span>

#include "contact/friction/friction_law.h"

namespace tricontact::contact {

/// Of contacts whose true pressure depends on what a point carries along the surface, too: of a
/// surface that is inclined to the direction in which it is pressed. Bounds without that are those
/// of points that carry nothing.
class CarriedFriction : public FrictionLaw {
  public:
    /// Largest traction of each point [Pa] beside the tractions along x that it carries now.
    virtual void bounds_beside(const Points& points, std::span<const double> traction,
                               std::span<double> bound) const = 0;
};

}  // namespace tricontact::contact
