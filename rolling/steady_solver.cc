#include "rolling/steady_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/friction_disc.h"
#include "contact/substrates/substrate.h"

namespace tricontact::rolling {

namespace {

using contact::norm;
using contact::operator+, contact::operator-, contact::operator*, contact::operator/;
using contact::TangentialField;
using contact::Vector2;

constexpr int max_newton_steps = 100;
// Far from the solution all may slip, and a long step of the creepage leads farther away; close to
// full sliding only long ones arrive.
constexpr int careful_steps = 20;
constexpr double force_tolerance = 1e-10;  // over sum bound A, as in contact::TangentialSolver

class Newton {
  public:
    Newton(const contact::Compliance& compliance, const SteadyProblem& problem, double tolerance,
           SteadySolution& solution)
        : compliance_(compliance),
          points_(compliance.points()),
          problem_(problem),
          tolerance_(tolerance),
          solution_(solution),
          active_(points_in_contact(problem.bound)),
          force_controlled_{!problem.drive.creepage[0], !problem.drive.creepage[1]},
          system_(compliance, active_, force_controlled_),
          alpha_(system_.local()),
          slipping_(active_.size()) {
        for (const std::size_t i : active_) total_bound_ += points_.area[i] * problem_.bound[i];
        check_force_is_carried();
        for (const std::size_t i : active_) mean_bound_ += problem_.bound[i] / active_.size();
        // On half-spaces both are of one size.
        constexpr double alike = 4;
        const double alone = alpha_ * mean_bound_;
        if (problem.slip_unit > 0 && alone > alike * problem.slip_unit)
            tolerance_ *= alike * problem.slip_unit / alone;
    }

    void run(int most_steps = max_newton_steps) {
        start();
        if (active_.empty()) return;
        for (int step = 0; step < most_steps; ++step) {
            update_slip();
            classify();
            update_slip();
            update_residual();
            if (solution_.residual <= tolerance_ && solution_.force_residual <= force_tolerance)
                return;
            move(solve_linear_system(step < careful_steps ? .5 : 10));
        }
        throw contact::NotConverged(fmt::format(
            "steady rolling: residual {:.2e} (tolerance {:.1e}), force residual {:.2e} after {} "
            "Newton steps; {} points in contact, {} slipping; creepage {:.3e}, {:.3e}",
            solution_.residual, tolerance_, solution_.force_residual, most_steps, active_.size(),
            std::ranges::count(slipping_, 1), solution_.creepage.longitudinal,
            solution_.creepage.lateral));
    }

    /// About the creepage at which all slides; known once run() has begun.
    double sliding_creepage() const { return sliding_creepage_; }

  private:
    static std::vector<std::size_t> points_in_contact(const std::vector<double>& bound) {
        std::vector<std::size_t> active;
        for (std::size_t i = 0; i < bound.size(); ++i)
            if (bound[i] > 0) active.push_back(i);
        return active;
    }

    /// t + s/alpha: inside the friction disc where the point sticks.
    Vector2 trial(std::size_t i) const {
        return solution_.traction.at(i) + solution_.slip.at(i) / alpha_;
    }

    void check_force_is_carried() const {
        Vector2 force{};
        for (int d = 0; d < 2; ++d)
            if (force_controlled_[d]) force[d] = problem_.drive.force[d];
        const bool any = force_controlled_[0] || force_controlled_[1];
        if (any && norm(force) >= total_bound_)
            throw contact::InputError(
                fmt::format("rolling: the force {:.6g} N reaches the friction limit {:.6g} N: the "
                            "contact slides as a whole; lower the force or prescribe the creepage",
                            norm(force), total_bound_));
    }

    void start() {
        const std::size_t n = points_.size();
        TangentialField& t = solution_.traction;
        if (t.size() != n) t = TangentialField(n);
        solution_.displacement = solution_.slip = TangentialField(n);
        for (std::size_t i = 0; i < n; ++i)
            t.set(i, contact::project_on_disc(t.at(i), problem_.bound[i]));
        Creepage& w = solution_.creepage;
        w.longitudinal = problem_.drive.creepage[0].value_or(w.longitudinal);
        w.lateral = problem_.drive.creepage[1].value_or(w.lateral);
        w.spin = problem_.drive.spin;
        solution_.iterations = 0;
        set_sliding_creepage();
    }

    /// What slides without creepage, and what tractions make slide.
    void set_sliding_creepage() {
        const TangentialField by_pressure =
            forward_gradient(points_, active_, problem_.displacement);
        double sliding = 0;
        for (const std::size_t i : active_)
            sliding = std::max(sliding, std::hypot(by_pressure.x[i], by_pressure.y[i]) +
                                            std::abs(problem_.drive.spin) *
                                                std::hypot(points_.x[i] - problem_.centre[0],
                                                           points_.y[i] - problem_.centre[1]));
        sliding_creepage_ = alpha_ * mean_bound_ + sliding;
    }

    void update_slip() {
        compliance_.tangential(solution_.traction, solution_.displacement);
        ++solution_.iterations;
        TangentialField all = solution_.displacement;
        for (std::size_t i = 0; i < all.size(); ++i)
            all.set(i, all.at(i) + problem_.displacement.at(i));
        solution_.slip = forward_gradient(points_, active_, all);
        const Creepage& w = solution_.creepage;
        const double ahead = contact::spin_point * points_.spacing[0];
        for (const std::size_t i : active_) {
            solution_.slip.x[i] += w.longitudinal - w.spin * (points_.y[i] - problem_.centre[1]);
            solution_.slip.y[i] += w.lateral + w.spin * (points_.x[i] + ahead - problem_.centre[0]);
        }
    }

    void update_residual() {
        double worst = 0;
        Vector2 force{};
        for (const std::size_t i : active_) {
            const Vector2 t = solution_.traction.at(i);
            const Vector2 p = contact::project_on_disc(trial(i), problem_.bound[i]);
            worst = contact::larger(worst, norm(t - p));
            force = force + points_.area[i] * t;
        }
        solution_.residual = worst / mean_bound_;
        solution_.force_residual = 0;
        for (int d = 0; d < 2; ++d) {
            missing_force_[d] = force_controlled_[d] ? problem_.drive.force[d] - force[d] : 0;
            solution_.force_residual = contact::larger(solution_.force_residual,
                                                       std::abs(missing_force_[d]) / total_bound_);
        }
    }

    /// One Newton step on the present zones; `farthest`: how far the creepage may go, over the
    /// sliding one, before it is held back.
    SteadySystem::Result solve_linear_system(double farthest) {
        std::vector<Vector2> tangent(active_.size());
        std::vector<double> curvature(active_.size(), 0.0);
        for (std::size_t k = 0; k < active_.size(); ++k) {
            if (!slipping_[k]) continue;
            const Vector2 t = solution_.traction.at(active_[k]), s = solution_.slip.at(active_[k]);
            const double bound = problem_.bound[active_[k]];
            tangent[k] = {-t[1] / bound, t[0] / bound};
            curvature[k] = std::max(0.0, contact::dot(s, t) / bound) / bound;
        }
        // Zones still move while the residual is large: solve no more exactly than that deserves.
        const double forcing =
            std::clamp(0.01 * std::max(solution_.residual, solution_.force_residual), 1e-10, 1e-2);
        SteadySystem::Result result;
        for (const double relief : {0., 1.}) {
            system_.set_zones(slipping_, tangent, curvature, relief);
            result = system_.solve(solution_.slip, missing_force_, forcing);
            solution_.iterations += result.iterations;
            if (norm(result.creepage) <= farthest * sliding_creepage_) break;
        }
        return result;
    }

    void move(const SteadySystem::Result& result) {
        solution_.creepage.longitudinal += result.creepage[0];
        solution_.creepage.lateral += result.creepage[1];
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            const Vector2 t = solution_.traction.at(i) + result.z.at(i);
            solution_.traction.set(i, slipping_[k] ? contact::onto_edge(t, problem_.bound[i]) : t);
        }
    }

    /// New zones from traction and slip; slipping points are put on their friction disc.
    void classify() {
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            const Vector2 y = trial(i), t = solution_.traction.at(i);
            slipping_[k] = norm(y) > problem_.bound[i];
            solution_.traction.set(
                i, contact::project_on_disc(slipping_[k] ? y : t, problem_.bound[i]));
        }
    }

    const contact::Compliance& compliance_;
    const contact::ContactPoints& points_;
    const SteadyProblem& problem_;
    double tolerance_;
    SteadySolution& solution_;
    const std::vector<std::size_t> active_;
    const std::array<bool, 2> force_controlled_;
    SteadySystem system_;
    const double alpha_;                  // [1/Pa]
    std::vector<std::uint8_t> slipping_;  // per active point
    Vector2 missing_force_{};
    double total_bound_ = 0, mean_bound_ = 0;
    double sliding_creepage_ = 0;  // the unit of its steps [-]
};

/// Where all cells slip, in a direction that pressure gives them, the force hardly follows the
/// creepage and Newton's steps lead nowhere: the force along x is bracketed, which grows with the
/// creepage, until Newton's method arrives from there. `unit`: a creepage of its size [-].
void bracket(const contact::Compliance& compliance, const SteadyProblem& problem, double tolerance,
             double unit, SteadySolution& solution) {
    Drive drive = problem.drive;  // creepage along x in place of the force
    const SteadyProblem at_creepage{problem.bound, problem.displacement, drive, problem.centre,
                                    problem.slip_unit};
    const auto missing_force = [&](double creepage) {
        drive.creepage[0] = creepage;
        Newton(compliance, at_creepage, tolerance, solution).run();
        double missing = problem.drive.force[0];
        for (std::size_t i = 0; i < problem.bound.size(); ++i)
            missing -= compliance.points().area[i] * solution.traction.x[i];
        return missing;
    };
    const auto arrives = [&] {
        SteadySolution guess = solution;
        try {
            Newton(compliance, problem, tolerance, guess).run(careful_steps);
        } catch (const contact::NotConverged&) {
            return false;
        }
        solution = std::move(guess);
        return true;
    };
    double low = -unit, high = unit;
    while (missing_force(low) < 0) low = 2 * low;
    while (missing_force(high) > 0) high = 2 * high;
    while (!arrives()) {
        const double middle = std::midpoint(low, high);
        if (middle <= low || middle >= high)
            throw contact::NotConverged(
                fmt::format("steady rolling: no creepage has the force {:.6g} N: {:.6g} N are "
                            "missing at {:.15g}, beyond it next to there",
                            problem.drive.force[0], missing_force(low), low));
        (missing_force(middle) > 0 ? low : high) = middle;
    }
}

}  // namespace

void solve_steady(const contact::Compliance& compliance, const SteadyProblem& problem,
                  double tolerance, SteadySolution& solution) {
    const SteadySolution start = solution;
    Newton newton(compliance, problem, tolerance, solution);
    try {
        newton.run();
    } catch (const contact::NotConverged&) {
        if (problem.drive.creepage[0]) throw;
        solution = start;
        bracket(compliance, problem, tolerance, newton.sliding_creepage(), solution);
    }
}

}  // namespace tricontact::rolling
