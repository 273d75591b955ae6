#pragma once

#include <Eigen/Dense>
#include <vector>

#include "theory/layer/layer_compliance.h"
#include "theory/layer/wave_numbers.h"
#include "theory/line_load.h"

namespace tricontact::theory {

/// The Fredholm equation of the second kind for axisymmetric frictionless contact of radius a on a
/// layer (Lebedev and Ufliand 1958 for the punch):
///   q(x) - (1/pi) ∫_0^a q(t) [H(x - t) + H(x + t)] dt = g(x),  0 <= x <= a,
///   H(s) = ∫_0^inf [1 - C33/C33_half-space](k b) cos(k s) dk,
/// by Nyström's method on a line mesh. On the half-space H = 0: the method of dimensionality
/// reduction; on a layer H couples its springs. H(x - t) + H(x + t) = 2 ∫ ... cos(kx) cos(kt) dk is
/// the same quadrature over k for every pair of points; that over k b ends at 24, where the deficit
/// is below 1e-17 on either base. The operator is symmetric and positive definite.
class LayerEquation {
  public:
    /// `layer` is checked. Throws contact::NotConverged if the mesh is too coarse for a positive
    /// definite operator.
    LayerEquation(const ElasticLayer& layer, LineMesh mesh);

    const LineMesh& mesh() const { return mesh_; }

    struct Solution {
        std::vector<double> values;  ///< q at the mesh's positions
        double edge = 0;             ///< q(a)
        double integral = 0;         ///< ∫_0^a q dx
    };
    /// g at the mesh's positions and at x = a; q in the unit of g.
    Solution solve(const std::vector<double>& g, double g_edge) const;

    /// u_x [m] at the contact centre under the traction p(r) along x [Pa] that belongs to the line
    /// load q [N/m]: (2 - nu) q(0)/(4 G) + ∫ (D11 + D22)/2 p^ k dk with D = C_layer - C_half-space,
    /// p^(k) = (1/pi) ∫_0^a q cos(kt) dt. Infinite on a frictionless base.
    double centre_shift(const std::vector<double>& q) const;

  private:
    ElasticLayer layer_;
    LineMesh mesh_;
    WaveNumbers waves_;
    Eigen::VectorXd kernel_;   // 2/(pi b) times weight times deficit [1/m]
    Eigen::MatrixXd cosines_;  // cos(k x): wave numbers by positions
    Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace tricontact::theory
