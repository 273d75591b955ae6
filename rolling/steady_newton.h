#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rolling/steady_solver.h"
#include "rolling/stick_inverse.h"

namespace tricontact::rolling {

/// How what is left of friction changes with the slip, per point [-]: by `own` times the change of
/// its own slip, and by `ahead` times the change of what the point ahead has left.
struct BoundSlopes {
    std::vector<double> own, ahead;
};

/// Bounds that follow from the state.
struct FollowingBound {
    /// Bound over that of the problem, per point [-].
    const std::function<std::vector<double>(const SteadySolution&)>& left;
    const std::function<BoundSlopes(const SteadySolution&)>& slopes;
};

/// The Newton iteration of solve_steady, see there; under bounds that follow from the state it
/// solves for both at once.
class SteadyNewton {
  public:
    static constexpr int max_steps = 100;
    // Far from the solution all may slip, and a long step of the creepage leads farther away; close
    // to full sliding only long ones arrive.
    static constexpr int careful_steps = 20;

    /// Updates `solution`, whose traction and creepage are the start. What it refers to shall
    /// outlive it.
    SteadyNewton(const contact::Compliance& compliance, const SteadyProblem& problem,
                 const SteadyTolerances& tolerances, SteadySolution& solution,
                 const FollowingBound* following = nullptr);

    /// Throws contact::NotConverged after `most_steps`.
    void run(int most_steps = max_steps);

    /// About the creepage at which all slides; known once run() has begun.
    double sliding_creepage() const { return sliding_creepage_; }
    /// Of bounds that follow from the state, what they are over those of the problem [-]: of
    /// slipping points by their tractions.
    std::vector<double> left() const;

  private:
    contact::Vector2 trial(std::size_t i) const;
    void check_force_is_carried() const;
    void start();
    void set_sliding_creepage();
    void update_slip();
    void update_residual();
    bool is_solved() const;
    SteadySystem::Result solve_linear_system(double farthest);
    void follow();
    void move(const SteadySystem::Result& result);
    void classify();

    const contact::Compliance& compliance_;
    const contact::ContactPoints& points_;
    const SteadyProblem& problem_;
    const FollowingBound* following_;
    SteadyTolerances tolerances_;
    SteadySolution& solution_;
    const std::vector<std::size_t> active_;
    const std::array<bool, 2> force_controlled_;
    const StickInverse own_inverse_;
    SteadySystem system_;
    const double alpha_;                  // [1/Pa]
    std::vector<double> bound_;           // per point [Pa]
    std::vector<std::uint8_t> slipping_;  // per active point
    contact::Vector2 missing_force_{};
    double total_bound_ = 0, mean_bound_ = 0;
    double bound_residual_ = 0;    // of bounds that follow, over those of the problem [-]
    double sliding_creepage_ = 0;  // the unit of its steps [-]
};

}  // namespace tricontact::rolling
