#pragma once

#include <optional>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/compliances/compliance.h"
#include "fem/mortar/surface_faces.h"

namespace tricontact::fem {

/// The smooth surface that the flat-edged faces of a mesh stand for. Each corner of a face gets the
/// quadratic function that fits the corners around it best and passes through its own height; nodes
/// between corners take the mean of those of the corners beside them. On a smooth surface that is
/// right to the fourth order of the size of a face, where the faces themselves have the second.
/// Kinks within the surface are rounded over the length of a face.
class SurfaceHeights {
  public:
    /// `height` [m] of the points of `surface`, of which those of corners are used.
    SurfaceHeights(const contact::ContactPoints& surface, std::vector<double> height);

    /// Of each point of the surface [m].
    const std::vector<double>& at_points() const { return height_; }
    /// Between them, biquadratic [m]; empty beside the surface.
    std::optional<double> at(const contact::Vector2& x) const;

  private:
    std::vector<SeenFace> faces_;
    std::vector<double> height_;
};

}  // namespace tricontact::fem
