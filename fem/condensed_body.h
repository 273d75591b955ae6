#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/compliances/compliance.h"
#include "fem/condensed_layer.h"
#include "fem/pressure_transfer.h"
#include "fem/whole_body.h"

namespace tricontact::fem {

/// What a contact asks of a body that was condensed besides the compliance of its patch. Pressure
/// acts into the body, traction in the plane of its patch, z points out of it.
class CondensedBody {
  public:
    /// `missing_reaction`: see CondensedLayer, of the same problem. `round_radius`: of a body in a
    /// round frame, see turn_to_round_frame() [m]; pressure and traction are those of that frame.
    /// `transfer`: of a body whose contact points are those of a pressure grid.
    CondensedBody(std::shared_ptr<const LayerProblem> problem,
                  std::array<std::vector<double>, 3> missing_reaction, double round_radius = 0,
                  std::optional<PressureTransfer> transfer = {});
    CondensedBody(CondensedBody&&) noexcept;
    ~CondensedBody();

    const LayerProblem& problem() const { return *problem_; }
    /// Force of what holds the body plus that of these tractions [N], zero but for errors.
    std::array<double, 3> missing_reaction(const contact::ContactPoints& points,
                                           std::span<const double> p,
                                           const contact::TangentialField& t) const;
    /// What that may be over the force, for the rounding of a stiff material.
    double allowed_missing_reaction(const contact::ContactPoints& points) const;
    /// Of interior(), before it is asked for.
    void solve_inside_by(InsideSolverOf without_factor) {
        inside_solver_of_ = std::move(without_factor);
    }
    /// Solves for the whole body, see WholeBody.
    contact::Interior interior(const contact::ContactPoints& points, std::span<const double> p,
                               const contact::TangentialField& t) const;

  private:
    std::shared_ptr<const LayerProblem> problem_;
    std::array<std::vector<double>, 3> missing_reaction_;
    double round_radius_;
    std::optional<PressureTransfer> transfer_;
    InsideSolverOf inside_solver_of_;
    mutable std::unique_ptr<WholeBody> whole_;
};

}  // namespace tricontact::fem
