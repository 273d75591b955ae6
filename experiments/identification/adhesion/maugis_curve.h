#pragma once

#include <vector>

#include "theory/adhesive/maugis_dugdale.h"

namespace tricontact::experiments {

/// Maugis' contact of a paraboloid on a half-space, whose surfaces attract each other by a constant
/// stress over a range, along the branch that is stable under force: many of its states at little
/// cost. Below the branch all is as at its end.
class MaugisCurve {
  public:
    /// R [m], E* [Pa], w [J/m^2], range above 0 [m].
    MaugisCurve(double radius, double modulus, double work, double range);

    double force_at(double indentation);  ///< [N]
    double radius_under(double force);    ///< of the contact within the ring of tension [m]
    /// Depth [m] at the end of the branch.
    double last_indentation() const { return nodes_.front().indentation * unit_depth_; }

    /// The range [m] of a lambda.
    static double range_of(double lambda, double radius, double modulus, double work);

  private:
    theory::MaugisContact at(double theory::MaugisContact::*control, double value);

    double lambda_, unit_force_, unit_depth_, unit_radius_;
    std::vector<theory::MaugisContact> nodes_;  // of radii that grow by a constant factor
};

}  // namespace tricontact::experiments
