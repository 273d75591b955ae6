#pragma once

#include <Eigen/Core>

namespace tricontact::theory {

/// Quadrature over x = k b in (0, 24), where the deficit of a layer against the half-space lives:
/// it is below 1e-17 beyond, on either base. Exact to rounding for the deficit times two waves of
/// the argument k r, r up to `radius_over_thickness` b (cosines or Bessel functions).
class WaveNumbers {
  public:
    explicit WaveNumbers(double radius_over_thickness);

    Eigen::Index size() const { return points_.size(); }
    const Eigen::VectorXd& points() const { return points_; }  ///< x, increasing
    const Eigen::VectorXd& weights() const { return weights_; }

    /// cos(x t) at all x, to a few units of rounding of x t.
    Eigen::VectorXd cosines(double t) const;

  private:
    Eigen::Index n_panels_;
    double width_;  // of a panel
    Eigen::VectorXd points_, weights_;
};

}  // namespace tricontact::theory
