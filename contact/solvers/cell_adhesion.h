#pragma once

#include <string>
#include <vector>

#include "contact/attraction/attraction.h"
#include "contact/base/pull_off.h"
#include "contact/compliances/compliance.h"
#include "contact/solvers/control.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::contact {

/// Adhesion without a range by cells of a half-space that let go one by one: a cell that touches
/// holds until its tension is sigma_c, at which the elastic energy of a square of its size that
/// carries sigma_c alone is w (Pohrt and Popov 2015). Cells meet where they would overlap, and gain
/// nothing by it.
class CellAdhesion {
  public:
    /// `attraction`: attraction_by_cell(); `name` and `tolerance` as AdhesiveNormal's.
    CellAdhesion(std::string name, const Compliance& compliance, const Attraction& attraction,
                 double tolerance);

    /// From `before` on, cell by cell. NormalSolution::released has what is lost on the way. Throws
    /// as AdhesiveNormal::follow().
    NormalSolution follow(const std::vector<double>& height, const NormalControl& control,
                          const NormalSolution& before) const;
    /// Pulls off by the depth, from this state until nothing holds.
    PullOff pull(const std::vector<double>& height, const NormalSolution& before) const;

  private:
    class Set;
    template <class Seen>
    void lower(Set& set, const NormalControl& control, NormalSolution& way, const Seen& seen) const;

    std::string name_;
    const Compliance& compliance_;
    double strength_, tolerance_;
};

}  // namespace tricontact::contact
