#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/compliances/compliance.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

class StickInverse;

/// What the frame's motion by one cell along x adds to the slip of the `active` points, per rolled
/// way: (u(x + h) - u(x))/h, 0 elsewhere.
contact::TangentialField forward_gradient(const contact::ContactPoints& grid,
                                          const std::vector<std::size_t>& active,
                                          const contact::TangentialField& u);

/// The Newton system of steady rolling for given stick and slip zones. Sticking points have two
/// unknowns; slipping ones move along the tangent of their friction disc only:
///   P M z + D z - C w = r,   C' z = c,   M = -d/dx A,
/// P the projection onto the admissible directions, D = (s.e)/bound on slipping points (the
/// curvature of the disc), C the total forces in the force-controlled directions, w the creepage.
/// A commutes with the step of one cell, of which M is the first difference: M is not symmetric,
/// but t'M t >= 0.
class SteadySystem {
  public:
    struct Result {
        contact::TangentialField z;  ///< traction [Pa]
        contact::Vector2 creepage;   ///< w [-], zero in creepage-controlled directions
        int iterations = 0;          ///< applications of the compliance
        double residual = 0;         ///< over the right-hand side
    };

    /// `active`: indices of the points in contact. `stick_inverse`: of this compliance.
    SteadySystem(const contact::Compliance& compliance, const std::vector<std::size_t>& active,
                 std::array<bool, 2> force_controlled, const StickInverse& stick_inverse);

    /// Slip over traction of a cell by itself [1/Pa], the scale of M.
    double local() const { return local_; }
    /// What stands per active point: whether it slips, and if so the unit tangent of its friction
    /// disc and the curvature D [1/Pa]. `relief` r [-]: the force balance becomes
    /// C' z + r C'C w/local = c, a step of the proximal point method (Rockafellar 1976) for the
    /// creepage. Where nearly all slip along the force, hardly any rotation carries more of it.
    void set_zones(std::vector<std::uint8_t> slipping, std::vector<contact::Vector2> tangent,
                   std::vector<double> curvature, double relief);
    /// Bounds that follow from the slip, per active point: what is missing of them [Pa], and their
    /// change by `own` [Pa] times that of the slip's length, and by `ahead` [-] times that of the
    /// point ahead. Slipping points then move along their traction as well; rows in this direction
    /// are local (z_e - db) = local missing. Empty: bounds are given.
    struct Following {
        std::vector<double> missing, own, ahead;
    };
    void set_following(Following following) { following_ = std::move(following); }
    /// `r` [-] on the points, `c` [N]: right-hand sides. `tolerance`: on the residual over the
    /// first.
    Result solve(const contact::TangentialField& r, const contact::Vector2& c,
                 double tolerance) const;

  private:
    // Vectors: x components of the active points, their y components, and two more for the creepage
    // and the force balance.
    Eigen::Index size() const { return 2 * static_cast<Eigen::Index>(active_.size()) + 2; }
    Eigen::VectorXd product(const Eigen::VectorXd& z) const;
    Eigen::VectorXd preconditioned(const Eigen::VectorXd& r) const;
    Eigen::VectorXd projected(const Eigen::VectorXd& f) const;
    Eigen::VectorXd without_balance(const Eigen::VectorXd& r) const;
    Eigen::VectorXd sliding(const Eigen::VectorXd& z) const;
    void add_missing(Eigen::VectorXd& right_hand_side) const;
    Eigen::VectorXd admissible(const Eigen::VectorXd& z) const;
    Eigen::VectorXd bound_change(const Eigen::VectorXd& slip_change) const;
    contact::Vector2 direction(Eigen::Index k) const { return {tangent_[k][1], -tangent_[k][0]}; }
    Eigen::Vector2d total(const Eigen::VectorXd& z) const;

    const contact::Compliance& compliance_;
    const StickInverse& stick_inverse_;
    const std::vector<std::size_t>& active_;
    std::array<bool, 2> force_controlled_;
    double local_;
    double area_ = 0;  // of the active points [m^2]
    std::vector<std::uint8_t> slipping_;
    std::vector<contact::Vector2> tangent_;
    std::vector<double> curvature_;
    Following following_;
    std::vector<std::uint8_t> sticks_;       // per point of the grid
    std::array<Eigen::VectorXd, 2> answer_;  // without balance, to a creepage of 1
    double relief_ = 0;
    Eigen::Matrix2d force_inverse_;
};

/// Steady rolling at given pressures: find tractions t on the substrate, |t| <= bound, such that
/// the slip s of rolling_contact.h, du/dx the difference to the next cell ahead, vanishes where
/// |t| < bound and points along t where |t| = bound.
struct SteadyProblem {
    const std::vector<double>& bound;              ///< mu p [Pa] per point, 0 outside the contact
    const contact::TangentialField& displacement;  ///< by all but t [m]
    const Drive& drive;
    contact::Vector2 centre{};  ///< of the spin [m]
    /// What slip is measured by, about the creepage of full sliding [-]: where a traction makes a
    /// point alone slip by far more, as on a soft interface, tractions are solved as much more
    /// exactly. 0: they are not.
    double slip_unit = 0;
    /// Of the compliance, which several problems may share; null: made for this one.
    const StickInverse* stick_inverse = nullptr;
};

struct SteadySolution {
    contact::TangentialField traction;      ///< t [Pa]
    contact::TangentialField displacement;  ///< A t [m]
    contact::TangentialField slip;          ///< s [-], 0 outside the contact
    Creepage creepage;
    int iterations = 0;         ///< applications of the compliance
    double residual = 0;        ///< see solve_steady
    double force_residual = 0;  ///< |sum t A - F| / sum bound A, worst force-controlled direction
};

struct SteadyTolerances {
    double residual = 0;
    double force = 1e-10;  ///< on force_residual; as in contact::TangentialSolver
};

/// Semismooth Newton method (active set) as in contact::TangentialSolver, for the one state that
/// rolling on no longer changes: a monotone variational inequality, whose Newton systems are not
/// symmetric (see SteadySystem). Its solution is where transient rolling on the same grid ends.
///
/// Residual: largest |t - P(t + s/alpha)| over the mean bound, P the projection onto the friction
/// disc, alpha the slip over the traction of a single cell.
/// The points of `compliance` form a grid, which the contact does not reach the edge of. Updates
/// `solution`, whose traction and creepage are the start (may be zero; clipped). Throws
/// NotConverged; InputError when the force exceeds what friction carries.
void solve_steady(const contact::Compliance& compliance, const SteadyProblem& problem,
                  const SteadyTolerances& tolerances, SteadySolution& solution);

}  // namespace tricontact::rolling
