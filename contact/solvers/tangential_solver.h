#pragma once

#include <array>
#include <memory>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/friction/friction_disc.h"
#include "contact/solvers/control.h"
#include "contact/solvers/tangential_system.h"

// The problem: docs/explanation/models/common.md, "What is solved in a step". Coulomb's law is one
// equation per point (Alart and Curnier 1991), P the projection onto the disc of the radius mu p:
//
//   t = P(y),  y = t + s/alpha,  s = D dU + u_previous - A t
//
//        .-----.             y inside the disc:  t = y, hence s = 0: the point sticks
//      /    t   \            y outside of it:    t on the edge and s along t: it slips
//     |     *----|---> y
//      \   mu p  /           alpha > 0 changes the zones on the way, but no solution
//        '-----'
//
// A Newton step takes the zones that y gives. A sticking point has two unknowns and the equation s
// = 0. The traction of a slipping point has the length mu p: it moves along the tangent e of its
// disc by z, which turns t by z/(mu p), and s has to turn with it: (s.t/|t|)/(mu p) z is the term
// `curvature` of the system. It is clipped at zero where s points against t, so that the matrix
// stays positive definite. Afterwards t is put back on the edge (`onto_edge`), an error of second
// order.
//
// Where bounds rise with the slip (Hardening), P is that of FrictionDisc: a third zone flows, with
// two unknowns and the equation s = (|t| - at_start)/slope t/|t|. It adds to the matrix what a
// layer of the compliance 1/slope along t would, from none (infinite slope: it sticks) to one that
// holds |t| (no slope: it slips). So any slope is solved in as many steps as Coulomb's law.
//
// Pressures stand still here. That keeps the matrix symmetric; with p as an unknown the bound mu p
// would make it unsymmetric. StaggeredSolver changes the pressures.
//
// Newton's method on zones may cycle, as any active set method with a full step. Projected
// gradients cannot: the problem at given pressures is a convex minimum (projected_gradient.h). They
// take over after `patience` steps without progress, each time for twice as many steps.

namespace tricontact::contact {

/// One step of frictional contact at given pressures: find tractions t on the substrate,
/// |t| <= bound, such that the slip s = D dU + u_previous - A t vanishes where |t| < bound and
/// points along t where |t| = bound. With `hardening` it may be less than bound where it slips.
struct TangentialProblem {
    const std::vector<double>& bound;              ///< per point [Pa], 0 outside the contact
    const TangentialField& previous_displacement;  ///< [m], before the step
    /// Per direction: total force on the substrate [N], or increment of the rigid shift [m].
    std::array<TangentialControl, 2> control;
    /// Displacement over traction of the contact as a whole [m/Pa], e.g. indentation over mean
    /// pressure: relates slip to traction in zones and residual.
    double contact_compliance;
    /// Of the surface whose own directions t and s are along.
    Tilt tilt = {};
    /// Times the solver's tolerances, of a solution that another is to follow.
    double looseness = 1;
    /// The displacements of all points are wanted.
    bool displaces_all = true;
    /// Of bounds that rise with the slip; null: they do not.
    const Hardening* hardening = nullptr;

    FrictionDisc disc(std::size_t i) const {
        return hardening ? FrictionDisc{hardening->at_start[i], bound[i], hardening->slope}
                         : FrictionDisc{bound[i], bound[i], 0};
    }

    /// The alpha that tells the zones on the way [m/Pa]. Where a traction makes a point slip by far
    /// more (`alone`) than the contact as a whole, as springs of an interface on mdr's line do,
    /// zones by the contact's compliance jump from step to step and lead nowhere.
    double zone_compliance(double alone) const {
        constexpr double alike = 4;  // on half-spaces and layers a point's is the smaller one
        return alone > alike * contact_compliance ? alone : contact_compliance;
    }
};

struct TangentialSolution {
    TangentialField traction;      ///< t [Pa]
    TangentialField displacement;  ///< A t [m], if wanted
    Vector2 shift_increment{};     ///< dU [m], indenter over substrate
    int iterations = 0;            ///< applications of the compliance
    double residual = 0;           ///< see TangentialSolver
    double force_residual = 0;  ///< |sum D t A - F| / sum bound A, worst force-controlled direction
};

/// Semismooth Newton method (active set): the unknowns are t where points stick and the traction's
/// angle where they slip; each linear system is symmetric positive definite on the null space of
/// the force balance and solved by projected, preconditioned conjugate gradients. Accelerated
/// projected gradients take over when the active set cycles.
///
/// Residual: largest |t - P(t + s/alpha)| over the mean bound, P the projection onto the friction
/// disc, alpha the contact's compliance. It reads:
/// slip of sticking points over the shift of full sliding, and angle between slip and traction.
class TangentialSolver {
  public:
    TangentialSolver(const Compliance& compliance, double tolerance);
    ~TangentialSolver();
    void set_tolerance(double tolerance) { tolerance_ = tolerance; }

    /// Updates `solution`, whose traction is the start (may be zero; clipped to the bound), and its
    /// shift increment too where a force is prescribed (zero: unknown).
    /// Where no point has a bound nothing is carried: shifts are followed, a force of 0 leaves the
    /// indenter where it is. Throws NotConverged; InputError when the force exceeds what friction
    /// carries.
    void solve(const TangentialProblem& problem, TangentialSolution& solution);

  private:
    class KeptOperators;

    const ActiveOperator& products_among(const std::vector<std::size_t>& active);

    const Compliance& compliance_;
    double tolerance_;
    std::unique_ptr<KeptOperators> kept_;  // of dense compliances
    // Of the last problem else: a contact that has not changed keeps its factor.
    std::vector<std::size_t> active_;
    OperatorMemory memory_;
    std::unique_ptr<const ActiveOperator> products_;
};

}  // namespace tricontact::contact
