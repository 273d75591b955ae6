#pragma once

#include <memory>
#include <vector>

#include "contact/substrates/substrate.h"
#include "fem/block/block_solver.h"
#include "fem/consistent_mass.h"
#include "fem/contact_surface.h"

namespace tricontact::fem {

/// A block as the contact sees it, without a matrix of its patch: a product is a solution of
/// BlockSolver, which begins from the last one of its kind.
class BlockCompliance final : public contact::Compliance {
  public:
    /// `tolerance` [-]: of each solution, see BlockSolver::solve().
    BlockCompliance(std::shared_ptr<const LayerProblem> problem, const BlockGrid& grid,
                    double tolerance, int n_threads);

    /// Displacements [m] under all tractions `t` [Pa].
    contact::SurfaceField displacement(const contact::SurfaceField& t) const;
    /// Force of the ground plus the force of the tractions of the last displacement(), over the
    /// latter [-].
    double missing_reaction() const;
    /// Displacements and pressures of all nodes and elements after the last displacement(), from
    /// which the next solution begins; assigned, it begins from others.
    const std::vector<double>& last_solution() const { return state_; }
    std::vector<double>& last_solution() { return state_; }
    int solutions() const { return n_solutions_; }    ///< so far
    int iterations() const { return n_iterations_; }  ///< in all of them
    const BlockGrid& grid() const { return solver_.mixed().grid(); }

    const contact::ContactPoints& points() const override { return surface_.points; }
    int n_threads() const override { return solver_.mixed().n_threads(); }
    bool is_coupled() const override { return true; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    double local_tangential() const override;
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;
    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override {
        return mass_.traction(points(), t, odd_in_y);
    }
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override;

    /// What it takes beside the mesh [bytes].
    static double bytes(const BlockGrid& grid) { return BlockSolver::bytes(grid) * 1.5; }

  private:
    std::vector<double> forces_of(const contact::SurfaceField& t) const;
    contact::SurfaceField solve(const contact::SurfaceField& t, std::vector<double>& start) const;

    std::shared_ptr<const LayerProblem> problem_;
    mutable BlockSolver solver_;
    ContactSurface surface_;
    ConsistentMass mass_;
    std::vector<std::size_t> node_;  // of each point
    double tolerance_;
    mutable std::vector<double> state_, of_product_;  // displacements and pressures
    mutable std::vector<double> forces_;              // of the last displacement()
    mutable int n_solutions_ = 0, n_iterations_ = 0;
};

}  // namespace tricontact::fem
