#pragma once

#include <vector>

#include "contact/bodies/indenter.h"
#include "fem/finite_strain/contact_frames.h"

namespace tricontact::fem {

/// What slips in a step: material points of the indenter over those of the substrate that they
/// touched when it began. A point that was open slips from when the indenter, of which but the
/// rolling and the indentation change, would have touched it.
///
/// Slip lies in the plane of the present surface. A paraboloid that rolls does not stay itself:
/// what is between the points along the mean of both normals is no slip. So rolling back leads
/// back, whatever the step.
class StepSlip {
  public:
    struct Start {
        const Pose& pose;
        const std::vector<Vector3>&
            position;  ///< of the contact points, x, y, into the substrate [m]
        const std::vector<double>& pressure;  ///< not positive: open
    };
    /// `rolling_radius` [m].
    StepSlip(const contact::Indenter& indenter, double rolling_radius, const Start& start,
             const Pose& now);

    /// Of the indenter over point i, which is now at x, along the frames' directions [m].
    contact::Vector2 at(std::size_t i, const ContactFrames& frames, const Vector3& x) const;

  private:
    std::vector<Vector3> touched_;  ///< where the indenter's points are now
    std::vector<Vector3> normal_;   ///< and its normals in them, as it has turned
};

}  // namespace tricontact::fem
