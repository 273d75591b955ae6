#include "walking/machine/stable_step.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace tricontact::walking {

namespace {

// Second derivatives of the elastic energy with respect to x, z and phi, in units of k_x.
Eigen::Matrix3d sticking_stiffness(const Machine& machine) {
    const Kappas& k = machine.kappas;
    const bool prism = machine.model == Machine::Model::prism;
    const Eigen::Vector3d stretch(-1, 0, k.kappa8), shear(1, 0, 1);
    Eigen::Matrix3d stiffness = k.kappa1 * stretch * stretch.transpose();
    for (const Spot& spring : springs_of(machine)) {
        const Eigen::Vector3d approach(0, 1, -normal_lever(spring, 0) / k.kappa3);
        // Two flanks of 45 degrees resist an approach across and along themselves.
        const double normal = prism ? k.kappa2 + 1 : spring.stiffness * k.kappa2;
        const double tangential = prism ? 2 : spring.stiffness;
        stiffness +=
            normal * approach * approach.transpose() + tangential * shear * shear.transpose();
    }
    return stiffness;
}

}  // namespace

double highest_frequency(const Machine& machine) {
    const auto& [vertical, rotation, coupling] = machine.mechanisms;
    const Kappas& k = machine.kappas;
    // 1/sqrt of the masses of x, z and phi; what may not move has no part in any vibration.
    const Eigen::DiagonalMatrix<double, 3> scale(1, vertical ? 1 : 0,
                                                 rotation ? k.kappa3 / std::sqrt(k.kappa7) : 0);
    const Eigen::Matrix3d scaled = scale * sticking_stiffness(machine) * scale;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(scaled, Eigen::EigenvaluesOnly);
    return std::sqrt(modes.eigenvalues().maxCoeff());
}

double stable_step(const Machine& machine) {
    return 2 / highest_frequency(machine);
}

}  // namespace tricontact::walking
