#pragma once

#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/solvers/control.h"

namespace tricontact::contact {

/// Pressures and what they displace on all points, u_z = A p.
struct PressedSurface {
    std::vector<double> pressure;      ///< p [Pa], >= 0
    std::vector<double> displacement;  ///< u_z [m]
    int iterations = 0;                ///< applications of the compliance
};

/// Corrects the pressures of a similar problem, where they are nearly right: Newton steps on the
/// points in contact, each solved by preconditioned conjugate gradients among these alone, whose
/// products cost less than those among all points. Pressures at which points leave or enter the
/// contact change its set for the next step. A force is prescribed.
class PressureCorrection {
  public:
    /// `tolerance`: see NormalSolver.
    PressureCorrection(const Compliance& compliance, double tolerance)
        : compliance_(compliance), tolerance_(tolerance) {}

    /// `start`: pressures, >= 0, somewhere > 0. False, and any `surface`, where it does not know
    /// how, or the start is not near enough to be worth it.
    bool correct(const std::vector<double>& height, double force, const std::vector<double>& start,
                 PressedSurface& surface) const;

  private:
    const Compliance& compliance_;
    double tolerance_;
};

}  // namespace tricontact::contact
