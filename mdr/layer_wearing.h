#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "mdr/worn_kernels.h"
#include "mdr/worn_rings.h"

namespace tricontact::mdr {

class LayerModel;

/// Wear of a body of revolution on the springs that a layer couples, along rings as WearingBed: the
/// layer relates line loads q and displacements of the line, pressures and the profile follow from
/// them as on the half-space. Of the surface's displacement u(r) = d - f(r) in the contact, the
/// line's is d - g(x) with
///   f(r) = 2/pi ∫_0^r g(x)/sqrt(r^2 - x^2) dx
/// whatever is below; q and p are the same load (theory/layer/layer_equation.h). So the normal
/// contact of a worn profile is exact; slips are those of the line, transformed as f is.
///
/// Rings are the line's elements on one side. Steps of the cycle are taken by the line itself; a
/// jump over n cycles solves, with D = n kappa s of the rings, C the layer's compliance and the
/// kernels T (depth -> g) and B (q -> p),
///   (C + T D B) q = d - g - T w   where the worn profile touches, q = 0 elsewhere,
/// after which w + D B q is worn. Under a force d follows from the sum of q.
class LayerWearing final : public WornRings {
  public:
    /// `model` has to live longer. Throws as WornRings.
    LayerWearing(LayerModel& model, std::unique_ptr<contact::WearingContact> line,
                 contact::WearProblem problem, double friction);

    contact::WornCycle cycle(const std::vector<double>& worn) override;
    std::vector<double> jump(const std::vector<double>& worn, const contact::WornCycle& now,
                             double n) override;
    void enlarge(const contact::ContactAtEdge& reached) override;

  private:
    void make_rings();
    /// Of both sides of the line, the mean; and of the rings, to both sides.
    Eigen::VectorXd folded(const std::vector<double>& on_line) const;
    std::vector<double> unfolded(const Eigen::VectorXd& on_rings) const;

    LayerModel& model_;
    std::unique_ptr<contact::WearingContact> line_;  // the elements, in one dimension
    Eigen::VectorXd unworn_;                         // g of the rings [m]
    Eigen::MatrixXd compliance_;                     // line load on both sides -> displacement
    std::unique_ptr<const WornKernels> kernels_;
};

}  // namespace tricontact::mdr
