#pragma once

#include <span>
#include <vector>

#include "contact/case.h"
#include "contact/substrates/relaxation.h"

namespace tricontact::contact {

/// The substrate of a case as elastic bodies whose sums creep:
///   u(t) = sum_m ∫ J_m(t - t') X_m dt(t'),   X_m = sum_j weight(m, j) A_j,
/// A_j the compliance of bodies[j]. One body where all the stiffness relaxes alike, else those of
/// StieltjesInterpolation (partly_relaxing_substrate.h).
struct CreepModes {
    std::vector<Case> bodies;
    std::vector<Retardation> creep;  ///< J_m
    std::vector<double> weights;     ///< row by row, see weight()

    double weight(std::size_t m, std::size_t j) const {
        return weights[m * (weights.size() / creep.size()) + j];
    }
};
/// Of a case with a relaxation.
CreepModes creep_modes(const Case& c);

/// Creep of a steady field w(x) that material flows through along -x at the speed v: it meets what
/// lies ahead first.
///   u(x) = J.relaxed w(x) - sum compliance_i e_i(x),
///   e_i(x) = w(x) - 1/l_i ∫_0^inf exp(-s/l_i) w(x + s) ds,   l_i = v time_i,
/// with w linear between cells, as the steps of contact::PartlyRelaxingSubstrate have it; ahead of
/// the cells, where w is smooth, by Gauss points of panels that grow with the distance.
class CreepAlongWay {
  public:
    /// `cell` [m] between values, `distance` [m] from the first of them back to where w is not
    /// smooth. `speed` [m/s]; 0: all has relaxed.
    CreepAlongWay(std::vector<Retardation> modes, double speed, double cell, double distance);

    /// How far ahead of the first cell w is asked for [m].
    const std::vector<double>& ahead() const { return ahead_; }
    /// Adds the displacements of a mode to `sum`. `cells`: w at cells from the foremost back;
    /// `ahead`: w at ahead().
    void add(std::size_t mode, std::span<const double> cells, std::span<const double> ahead,
             std::span<double> sum) const;

  private:
    double first_memory(double length, double first, std::span<const double> ahead) const;

    std::vector<Retardation> modes_;
    double speed_, cell_;
    std::vector<double> ahead_, weights_;  // [m]
};

}  // namespace tricontact::contact
