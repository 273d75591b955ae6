#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/substrates/relaxation.h"
#include "fem/discretisation.h"
#include "fem/finite_strain/relaxing_branch.h"

namespace tricontact::fem {

struct ElementBatch;

/// Of functions that are linear in each element.
using Amplitudes = std::vector<std::array<double, 4>>;

/// The state of a body at finite strains: displacements and, an unknown of its own, the pressure,
/// which is linear in each element. Recomputing it as K (J - 1) would multiply the rounding of
/// displacements by K.
struct StrainedState {
    std::vector<double> displacement;  ///< u [m], x, y, z of each node; zero where held
    Amplitudes mean_stress;            ///< see StrainedBody [Pa m^3/2]
};

/// What a relaxing body remembers of its past, at the Gauss points: see relaxing_branch.h.
struct StrainMemory {
    std::vector<Symmetric3<Lanes>> strain;   ///< E_bar at the end of the last step, by points
    std::vector<Symmetric3<Lanes>> viscous;  ///< E_i, by points and branches
    Amplitudes dilatation;                   ///< e of J - 1 at the end of the last step [m^3/2]
    Amplitudes viscous_dilatation;           ///< h by elements and branches, see RelaxationStep
};

/// A step of a relaxing body: what its memory has become but for the strain at the end.
struct RelaxingStep {
    struct Branch {
        Symmetric3<Lanes> remembered;  ///< E_i before its determinant is made 1, but for
        Lanes share;                   ///< this times E_bar at the end
    };
    std::vector<Branch> branches;  ///< by points and branches
    Amplitudes dilatation;         ///< h but for gain e, by elements and branches
    Amplitudes remembered;         ///< their sum: q is K (stiffness e + this)
    std::vector<double> gain;      ///< see contact::RelaxationStep
    double duration = 0;           ///< [s]
    double stiffness = 1;          ///< of the step at small strains, over the relaxed one
};

/// A hyperelastic body of Q2 displacements and discontinuous linear pressures q,
///   int W(F) - ... + q (J - 1) - q^2/(2K),
/// the finite strain form of the Q2/P1 element of Discretisation: at small strains their forces are
/// the same. Pressures are linear functions of the reference position, orthonormal in each element.
///
/// It may relax: each branch of the relaxation is a Maxwell element of the same elasticity beside
/// it, see relaxing_branch.h, and Poisson's ratio stays: q is to the mean of J - 1 as in the linear
/// substrate.
class StrainedBody {
  public:
    /// `c01_ratio`: c01/(c10 + c01) of each region. What has relaxed has the moduli of the
    /// discretisation. Throws contact::InputError for a relaxation that check() refuses.
    StrainedBody(const Discretisation& discretisation,
                 const std::array<double, meshes::n_regions>& c01_ratio,
                 const contact::Relaxation& relaxation = {});
    ~StrainedBody();

    struct Response {
        /// Forces of the body on its nodes' other side, by nodes [N]: what must be applied there.
        std::vector<double> force;
        /// int psi (J - 1) - q/K [m^3/2]: zero in a solution. K and q are those that a step of
        /// relaxation sees, see RelaxingStep.
        Amplitudes excess_volume;
        /// `force` if the excess volume were taken away linearly: + K B' excess. What a step with
        /// the linear stiffness has to balance.
        std::vector<double> effective_force;
        double energy = 0;        ///< stored [J]
        double least_volume = 1;  ///< smallest J at any Gauss point; not above 0: inverted elements
    };
    /// A mirrored body's half, as its mesh is. Of a relaxing body all that has relaxed.
    void evaluate(const StrainedState& state, Response& response) const;

    StrainMemory unstrained() const;
    /// A step of this duration [s], which may be 0 or infinite, in which strains change linearly.
    RelaxingStep begin(const StrainMemory& memory, double duration) const;
    /// At the end of the step; the branches' energy is part of the stored one.
    void evaluate(const StrainedState& state, const RelaxingStep& step, Response& response) const;
    /// Of the branches in a step [J].
    struct StepEnergies {
        double dissipated = 0;  ///< not negative
        double work = 0;        ///< of what strains them: stored + dissipated but for O(dt^3)
    };
    /// Ends the step in this state, which `memory`, as the step began from it, learns.
    StepEnergies finish(const StrainedState& state, const RelaxingStep& step,
                        StrainMemory& memory) const;

    /// The inside in this state: points are undeformed, stresses Cauchy's, extrapolated as
    /// Discretisation does. `applied` is left to the caller; a mirrored body's halves are added up.
    contact::Interior interior(const Discretisation& discretisation, const StrainedState& state,
                               const RelaxingStep& step) const;
    /// Largest at any Gauss point, of the principal stretches l1 >= l2 >= l3.
    struct Extremes {
        double stretch = 1;  ///< l1
        double shear = 0;    ///< l1 - l3: what simple shear is called by
    };
    Extremes extremes(const StrainedState& state) const;

    /// The state with the pressures of what has relaxed beside the branches.
    StrainedState springs(StrainedState state, const StrainMemory& memory) const;

    /// Adds to the state a displacement that the linear stiffness of the step found, and the
    /// pressures that belong to it: K (B du + excess).
    void add(std::span<const double> displacement, const Response& before, const RelaxingStep& step,
             StrainedState& state) const;
    StrainedState at_rest() const;
    std::size_t n_cells() const { return n_cells_; }
    double root_of_cell() const;  ///< of the mean volume of an element [m^3/2]

  private:
    double bulk(std::size_t cell) const;
    /// e [m^3/2].
    double dilatation(const StrainedState& state, const RelaxingStep& step, std::size_t cell,
                      int m) const;
    double energy_of_volume(const StrainedState& state, const RelaxingStep& step,
                            std::size_t cell) const;
    void remember_volume(const StrainedState& state, const RelaxingStep& step, StrainMemory& memory,
                         StepEnergies& energies) const;

    std::vector<ElementBatch> batches_;
    std::size_t n_nodes_ = 0, n_cells_ = 0;
    contact::Relaxation relaxation_;
};

}  // namespace tricontact::fem
