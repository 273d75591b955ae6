#pragma once

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// A pin along y on the lowest point of a round hole: `x` is the arc on the pin, R times the angle
/// theta from that point, and the height is the gap along the pin's radius over cos(theta), so that
/// an approach d along z closes all heights by d (see fem/planar/pair.h). Infinite from 89 degrees
/// on.
class PinInHole final : public Indenter {
  public:
    /// Radii [m] of pin and hole, 0 < radius < hole_radius; InputError otherwise.
    PinInHole(double radius, double hole_radius);

    double height(double x, double y) const override;
    Vector2 slope(double x, double y) const override;
    bool presses_like_a_ball() const override { return false; }

  private:
    double radius_, hole_radius_;
};

}  // namespace tricontact::contact
