#pragma once

#include <array>
#include <span>
#include <vector>

#include "fem/discretisation.h"
#include "fem/finite_strain/hyperelastic.h"

namespace tricontact::fem {

struct ElementBatch;

/// The state of a body at finite strains: displacements and, an unknown of its own, the pressure,
/// which is linear in each element. Recomputing it as K (J - 1) would multiply the rounding of
/// displacements by K.
struct StrainedState {
    std::vector<double> displacement;  ///< u [m], x, y, z of each node; zero where held
    /// Amplitudes of the mean stress in each element [Pa m^3/2], see StrainedBody.
    std::vector<std::array<double, 4>> mean_stress;
};

/// A hyperelastic body of Q2 displacements and discontinuous linear pressures q,
///   int W(F) - ... + q (J - 1) - q^2/(2K),
/// the finite strain form of the Q2/P1 element of Discretisation: at small strains their forces are
/// the same. Pressures are linear functions of the reference position, orthonormal in each element.
class StrainedBody {
  public:
    /// `c01_ratio`: c01/(c10 + c01) of each region.
    StrainedBody(const Discretisation& discretisation,
                 const std::array<double, meshes::n_regions>& c01_ratio);
    ~StrainedBody();

    struct Response {
        /// Forces of the body on its nodes' other side, by nodes [N]: what must be applied there.
        std::vector<double> force;
        /// Per element int psi (J - 1) - q/K [m^3/2]: zero in a solution.
        std::vector<std::array<double, 4>> excess_volume;
        /// `force` if the excess volume were taken away linearly: + K B' excess. What a step with
        /// the linear stiffness has to balance.
        std::vector<double> effective_force;
        double energy = 0;        ///< stored [J]
        double least_volume = 1;  ///< smallest J at any Gauss point; not above 0: inverted elements
    };
    /// A mirrored body's half, as its mesh is.
    void evaluate(const StrainedState& state, Response& response) const;
    /// Adds to the state a displacement that the linear stiffness found, and the pressures that
    /// belong to it: K (B du + excess).
    void add(std::span<const double> displacement, const Response& before,
             StrainedState& state) const;
    StrainedState at_rest() const;
    std::size_t n_cells() const { return n_cells_; }

  private:
    std::vector<ElementBatch> batches_;
    std::size_t n_nodes_ = 0, n_cells_ = 0;
};

}  // namespace tricontact::fem
