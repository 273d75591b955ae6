#pragma once

#include <memory>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/solvers/control.h"

namespace tricontact::contact {

/// Frictionless normal contact at one position of the indenter.
struct NormalSolution {
    std::vector<double> pressure;      ///< p [Pa], >= 0 but for a tension
    std::vector<double> displacement;  ///< u_z [m], into the substrate
    double indentation = 0;            ///< d [m]
    /// What errors of displacements are compared with [m]: d, or the mean displacement under the
    /// pressures where that is more, since strong friction may lift the indenter.
    double length = 0;
    double force = 0;  ///< F_N [N]
    int iterations = 0;
    /// Largest |gap| where p > 0 and largest penetration elsewhere, over `length` [-].
    double residual = 0;
    double rounding = 0;          ///< what the rounding of displacements may leave of it [-]
    std::vector<double> share{};  ///< in contact, per point (ContactShare); empty: not asked for
    /// Of surfaces that attract each other, by AdhesiveNormal: their tension s, which `pressure`
    /// contains (p = q - s, q >= 0 by touch) [Pa], 0 or more; else empty. The energies of the state
    /// (elastic and of the tension) and what jumps on the way to it lose [J].
    std::vector<double> tension{};
    double energy = 0, released = 0;
    /// What the work of the force on the smooth parts of the way differs by from what it stores,
    /// over that [-].
    double unbalanced = 0;
    double pull = 0;  ///< of the tension, in all [N]

    double touch_force() const { return force + pull; }  ///< of q [N]
    bool attracts() const { return !tension.empty(); }
    /// Whether a point touches.
    bool touches(std::size_t i) const { return attracts() ? share[i] > 0 : pressure[i] > 0; }
};

class NormalActiveSet;

/// Force or indentation prescribed. Conjugate gradients with active set, Polonsky & Keer (1999),
/// Wear 231, 206-219; where the compliance exposes its matrix, NormalActiveSet first; on large
/// grids NormalNewton first.
class NormalSolver {
  public:
    /// `tolerance`: on NormalSolution::residual, or its rounding where that is more.
    NormalSolver(const Compliance& compliance, double tolerance);

    /// `height`: the indenter over each point [m], infinity outside the body. `start`: pressures of
    /// a similar problem, or empty. A height that the indentation nowhere reaches gives no force.
    /// Of a solution that another is to follow, the rounding is not looked for unless it decides.
    /// Throws NotConverged.
    NormalSolution solve(const std::vector<double>& height, const NormalControl& control,
                         const std::vector<double>& start = {}, bool is_last = true) const;

  private:
    const Compliance& compliance_;
    double tolerance_;
    std::shared_ptr<NormalActiveSet> active_set_;  // null without a matrix
};

}  // namespace tricontact::contact
