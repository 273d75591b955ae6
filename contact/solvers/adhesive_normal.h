#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/attraction/attraction.h"
#include "contact/attraction/ring_tension.h"
#include "contact/solvers/cell_adhesion.h"
#include "contact/solvers/contact_share.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::contact {

/// Frictionless normal contact of surfaces that attract each other, which depends on the state that
/// it begins from: contact jumps in and lets go at different depths. Equations in
/// docs/explanation/adhesion.md.
class AdhesiveNormal {
  public:
    /// `name`: for messages; `tolerance` as that of NormalSolver.
    AdhesiveNormal(std::string name, const Compliance& compliance, const Attraction& attraction,
                   double tolerance);

    const Attraction& attraction() const { return attraction_; }
    /// Null unless cells let go one by one.
    const CellAdhesion* by_cell() const { return cells_ ? &*cells_ : nullptr; }
    /// The stable state to which `before` goes over when the control changes monotonically to this
    /// one; `before` without a tension: no attraction at all. Heights as those of NormalSolver.
    /// NormalSolution::released tells what is set free on the way, bisected where something jumps.
    /// Throws InputError when a force pulls the surfaces off, NotConverged.
    NormalSolution follow(const std::vector<double>& height, const NormalControl& control,
                          const NormalSolution& before) const;
    /// Whether bodies that are held together, or not pressed yet, have another state at this load,
    /// apart or together. Of loads that press it is not asked.
    bool has_other_state(const std::vector<double>& height, const NormalControl& control,
                         const NormalSolution& now) const;
    /// Of the tension from the touch to these gaps, per point [J/m^2].
    std::vector<double> separation_work(const std::vector<double>& gap) const;
    /// As follow() at once.
    NormalSolution settle(const std::vector<double>& height, const NormalControl& control,
                          const NormalSolution& before) const;

  private:
    struct Iterate;  // of a tension
    class Way;
    void press(const std::vector<double>& height, const NormalControl& control, double precision,
               Iterate& now) const;
    void update_tension(Iterate& now) const;
    NormalSolution finish(Iterate now) const;
    std::optional<NormalSolution> settled(const std::vector<double>& height,
                                          const NormalControl& control,
                                          const NormalSolution& before) const;
    double freed(const NormalSolution& before, const NormalSolution& after) const;
    NormalSolution resolve(const std::vector<double>& height, const NormalControl& from,
                           const NormalControl& to, const NormalSolution& before,
                           NormalSolution after, int depth) const;
    double attracted_area(const NormalSolution& s) const;

    std::string name_;
    const Compliance& compliance_;
    Attraction attraction_;
    double tolerance_;
    GapWidths widths_;
    std::optional<RingTension> rings_;  // of a contact of revolution, in place of widths
    std::optional<ContactShare> share_;
    std::optional<CellAdhesion> cells_;
    NormalSolver exact_;
};

}  // namespace tricontact::contact
