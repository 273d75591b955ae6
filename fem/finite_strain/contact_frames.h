#pragma once

#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/solvers/tangential_system.h"
#include "fem/dense_compliance.h"
#include "fem/finite_strain/indenter_motion.h"

namespace tricontact::fem {

/// The indenter's surface at points of the substrate's: height, and the directions along which
/// tractions act. A pressure of the vertical component p pushes by p (slope, 1), x, y and into the
/// substrate, which is normal to the surface; friction acts along the two orthonormal directions
/// that x and y become when the surface is tilted the shortest way. Tractions are forces over the
/// areas of the undeformed surface.
class ContactFrames {
  public:
    /// Of the points at `position` [m] under the indenter at `lowest_point`.
    ContactFrames(const contact::Indenter& indenter, const std::vector<Vector3>& position,
                  const contact::Vector2& lowest_point);

    std::size_t size() const { return height_.size(); }
    /// Over the lowest point [m]; infinite beside the body.
    double height(std::size_t i) const { return height_[i]; }
    const contact::TangentialField& slope() const { return slope_; }
    /// Length of (slope, 1): what friction is bounded by is mu times it times p.
    double stretch(std::size_t i) const { return stretch_[i]; }
    /// (slope, 1) of the length 1.
    Vector3 normal(std::size_t i) const {
        return {slope_.x[i] / stretch_[i], slope_.y[i] / stretch_[i], 1 / stretch_[i]};
    }
    /// Components of a displacement along (slope, 1).
    double along_normal(std::size_t i, const Vector3& u) const {
        return slope_.x[i] * u[0] + slope_.y[i] * u[1] + u[2];
    }
    contact::Vector2 along_surface(std::size_t i, const Vector3& u) const {
        return {dot(tangent_[i][0], u), dot(tangent_[i][1], u)};
    }
    Vector3 traction(std::size_t i, double p, const contact::Vector2& t) const;
    /// `factor` times the compliance, between tractions and displacements in these directions:
    /// normal ones, then those of friction.
    DenseCompliance turned(const contact::Compliance& compliance, double factor) const;

  private:
    std::vector<double> height_, stretch_;
    contact::TangentialField slope_;
    std::vector<std::array<Vector3, 2>> tangent_;
};

}  // namespace tricontact::fem
