#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "fem/finite_strain/strained_body.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::test {

using Tensor = Eigen::Matrix3d;

inline Tensor dev(const Tensor& a) {
    return a - a.trace() / 3 * Tensor::Identity();
}

/// A block of one material, its volume near that of 2 x 1.5 x 1 mm, its elements distorted.
struct BlockSpec {
    contact::Material material{3e6, .5};
    double c01_ratio = 0;
    contact::Relaxation relaxation;
    int n = 2;  ///< elements in each direction
};

/// Uniform strains of a block, and the stresses that its nodes' forces are in balance with.
class StrainedBlock {
  public:
    explicit StrainedBlock(const BlockSpec& spec)
        : discretisation(problem_of(spec)),
          body(discretisation, {spec.c01_ratio, 0.}, spec.relaxation),
          memory(body.unstrained()),
          shear_modulus(spec.material.shear_modulus()) {}

    /// u = (F - 1) X, no mean stress.
    fem::StrainedState state_of(const Tensor& f) const {
        fem::StrainedState state = body.at_rest();
        const Tensor h = f - Tensor::Identity();
        for (std::size_t i = 0; i < nodes().size(); ++i) {
            const Eigen::Vector3d u = h * position(i);
            for (int a = 0; a < 3; ++a) state.displacement[3 * i + a] = u[a];
        }
        return state;
    }
    /// Mean first Piola-Kirchhoff stress [Pa]: int P dV = sum of f x', by the divergence theorem.
    Tensor piola(const std::vector<double>& force) const {
        Tensor sum = Tensor::Zero();
        for (std::size_t i = 0; i < nodes().size(); ++i)
            sum += Eigen::Vector3d(&force[3 * i]) * position(i).transpose();
        return sum / volume;
    }
    static Tensor cauchy(const Tensor& piola, const Tensor& f) {
        return piola * f.transpose() / f.determinant();
    }

    /// One step of the block to the deformation gradient F.
    struct Step {
        Tensor piola, cauchy;       ///< without mean stress [Pa]
        double energy, relaxed;     ///< stored in all, and without the branches [J/m^3]
        double dissipated, work;    ///< [J/m^3]
        std::vector<double> force;  ///< by nodes [N]
    };
    Step step(const Tensor& f, double duration) {
        const auto state = state_of(f);
        const auto begun = body.begin(memory, duration);
        fem::StrainedBody::Response response;
        body.evaluate(state, response);
        const double relaxed = response.energy / volume;
        body.evaluate(state, begun, response);
        const auto energies = body.finish(state, begun, memory);
        const Tensor p = piola(response.force);
        return {p,
                cauchy(p, f),
                response.energy / volume,
                relaxed,
                energies.dissipated / volume,
                energies.work / volume,
                response.force};
    }

    static constexpr double volume = 3e-9;  // [m^3], planes stay where they are

    fem::Discretisation discretisation;
    fem::StrainedBody body;
    fem::StrainMemory memory;
    double shear_modulus;

    const std::vector<std::array<double, 3>>& nodes() const { return discretisation.space.nodes; }
    Eigen::Vector3d position(std::size_t node) const {
        return Eigen::Vector3d(nodes()[node].data());
    }

  private:
    static fem::LayerProblem problem_of(const BlockSpec& spec) {
        fem::LayerProblem problem;
        problem.mesh = box_mesh({even(-1e-3, 1e-3, spec.n), even(-.75e-3, .75e-3, spec.n),
                                 even(-1e-3, 0, spec.n), 1e-3, .75e-3});
        distort(problem.mesh, .1e-3);
        problem.materials = {spec.material, spec.material};
        return problem;
    }
};

/// Deformation gradients with det F = 1, of simple shear in the plane xz, of uniaxial stretch
/// along z.
inline Tensor simple_shear(double gamma) {
    Tensor f = Tensor::Identity();
    f(0, 2) = gamma;
    return f;
}
inline Tensor uniaxial(double stretch) {
    const double across = 1 / std::sqrt(stretch);
    return Eigen::Vector3d(across, across, stretch).asDiagonal();
}
inline Tensor rotation(double angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// dev of the Kirchhoff stress of Mooney-Rivlin [Pa] for the isochoric left Cauchy-Green tensor b:
/// Ogden (1984), Non-Linear Elastic Deformations, ch. 4: 2 dev[(c10 + c01 I1) b - c01 b^2].
inline Tensor mooney_rivlin(const Tensor& b, double c10, double c01) {
    return 2 * dev((c10 + c01 * b.trace()) * b - c01 * b * b);
}

/// log2 of the ratios of consecutive errors.
inline std::vector<double> orders(const std::vector<double>& errors) {
    std::vector<double> orders;
    for (std::size_t i = 1; i < errors.size(); ++i)
        orders.push_back(std::log2(errors[i - 1] / errors[i]));
    return orders;
}

}  // namespace tricontact::test
