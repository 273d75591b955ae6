#pragma once

#include <Eigen/Core>

namespace tricontact::mdr {

/// Linear maps between values at the nodes rho_j = j h, rho = sqrt(r^2 - c^2): slips and what is
/// worn off g are linear in x^2 between them, as those of a paraboloid are, line loads linear in
/// rho. Each piece is integrated exactly; see WearingBed for the integrals.
struct WornKernels {
    Eigen::MatrixXd image;     ///< worn depth -> what it adds to g
    Eigen::MatrixXd pressure;  ///< q -> p
    Eigen::MatrixXd slip;      ///< s_1 -> s; its inverse is `image`

    /// `n` nodes, their spacing `h` > 0 and `c` >= 0 [m].
    WornKernels(int n, double h, double c);
};

}  // namespace tricontact::mdr
