#pragma once

#include <Eigen/Dense>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "theory/layer/layer_compliance.h"
#include "theory/springs/abel_elements.h"

namespace tricontact::theory {

/// What a bonded layer takes off the displacements of AbelElements on a half-space of its material:
///   M Δu(r) = -(2/pi) ∫_0^inf D(k b) J_0(k r) ∫_0^1 g cos(k x) dx dk,
/// with the deficit D of the normal compliance, and of the tangential one's mean over directions.
struct LayerCorrection {
    Eigen::MatrixXd normal, tangential;  ///< M Δu at all nodes by g
    Eigen::VectorXd uniform;             ///< tangential, of t = 1
};

/// For each ratio of contact radius to thickness; interpolated between ratios that are computed
/// when first needed, 1e-5 of the displacements.
class AbelLayer {
  public:
    /// Throws contact::InputError unless -1 < nu <= 1/2.
    explicit AbelLayer(double poisson);

    /// On so many elements. `ratio`: a/b > 0. Throws contact::InputError above 8, where other
    /// theories are at home.
    LayerCorrection at(int n, double ratio);

  private:
    const LayerCorrection& node(int n, int place);

    double poisson_;
    std::mutex mutex_;
    std::map<std::pair<int, int>, LayerCorrection> nodes_;
};

}  // namespace tricontact::theory
