#include "contact/solvers/tangential_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/error.h"
#include "contact/solvers/projected_gradient.h"
#include "contact/special_values.h"

namespace tricontact::contact {

namespace {

constexpr int max_newton_steps = 200;
constexpr int patience = 8;              // Newton steps without progress before gradients take over
constexpr int gradient_iterations = 60;  // at first, twice as many each time, up to
constexpr int most_gradient_iterations = 64 * gradient_iterations;
constexpr int cg_iterations = 300;
constexpr double force_tolerance = 1e-10;  // over sum bound A; ten times finer than promised

class Newton {
  public:
    Newton(const Compliance& compliance, const std::vector<std::size_t>& active,
           const ActiveOperator& products, const TangentialProblem& problem, double tolerance,
           TangentialSolution& solution)
        : compliance_(compliance),
          active_(active),
          products_(products),
          area_(compliance.points().area),
          problem_(problem),
          tolerance_(tolerance),
          alpha_(problem.contact_compliance),
          solution_(solution) {
        for (int d = 0; d < 2; ++d)
            force_controlled_[d] = problem.control[d].kind == TangentialControl::Kind::force;
        sum_bounds();
        check_force_is_carried();
        system_.emplace(compliance_, active_, products_, force_controlled_, problem_.tilt);
    }

    void run() {
        solution_.iterations = 0;
        start();
        double best = infinity;
        for (int step = 0; step < max_newton_steps; ++step) {
            update_slip();
            update_residual();
            // A start taken as it is would bring its error back in each period: a drift.
            if (converged() && !(step == 0 && shift_is_given_)) {
                if (!products_.displaces_all())
                    compliance_.tangential(traction(), solution_.displacement);
                return;
            }
            without_progress_ = solution_.residual < 0.9 * best ? 0 : without_progress_ + 1;
            best = std::min(best, solution_.residual);
            if (without_progress_ >= patience || !solve_linear_system()) {
                take_gradient_steps();
                without_progress_ = 0;
                best = infinity;
            }
            classify();
        }
        throw NotConverged(
            fmt::format("tangential contact: residual {:.2e} (tolerance {:.1e}), force residual "
                        "{:.2e} after {} "
                        "Newton steps; {} points in contact, {} slipping",
                        solution_.residual, tolerance_, solution_.force_residual, max_newton_steps,
                        active_.size(), std::count(slipping_.begin(), slipping_.end(), 1)));
    }

  private:
    TangentialField& traction() { return solution_.traction; }

    void sum_bounds() {
        for (const std::size_t i : active_) {
            total_bound_ += area_[i] * problem_.bound[i];
            active_area_ += area_[i];
        }
        mean_bound_ = total_bound_ / active_area_;
    }

    void check_force_is_carried() const {
        Vector2 force{};
        for (int d = 0; d < 2; ++d)
            if (force_controlled_[d]) force[d] = problem_.control[d].value;
        if (norm(force) >= total_bound_)
            throw InputError(fmt::format(
                "tangential contact: the force {:.6g} N reaches the friction limit {:.6g} N: the "
                "contact slides as a whole; lower the tangential force",
                norm(force), total_bound_));
    }

    /// Starts from the given traction; points that it loads to the bound slip at first. A given
    /// shift increment tells better which do.
    void start() {
        const std::size_t n = area_.size();
        if (traction().size() != n) traction() = TangentialField(n);
        solution_.displacement.x.resize(n);
        solution_.displacement.y.resize(n);
        slipping_.assign(active_.size(), 0);
        slip_.assign(active_.size(), Vector2{});
        std::size_t next = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (next == active_.size() || active_[next] != i) {
                traction().set(i, {0, 0});
                continue;
            }
            const Vector2 t = traction().at(i);
            slipping_[next++] = norm(t) >= problem_.bound[i] * (1 - 1e-12);
            traction().set(i, project_on_disc(t, problem_.bound[i]));
        }
        for (int d = 0; d < 2; ++d)
            if (force_controlled_[d])
                shift_is_given_ |= solution_.shift_increment[d] != 0;
            else
                solution_.shift_increment[d] = problem_.control[d].value;
        if (!shift_is_given_) return;
        update_slip();
        classify();
    }

    void update_slip() {
        products_.apply(traction(), solution_.displacement);
        ++solution_.iterations;
        const auto& before = problem_.previous_displacement;
        const auto& now = solution_.displacement;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            slip_[k] = problem_.tilt.apply(i, solution_.shift_increment) + before.at(i) - now.at(i);
        }
    }

    /// t + s/alpha: inside the friction disc where the point sticks.
    Vector2 trial(std::size_t k) const {
        return solution_.traction.at(active_[k]) + slip_[k] / alpha_;
    }

    void update_residual() {
        double worst = 0;
        Vector2 force{};
        on_bound_ = true;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            const Vector2 t = traction().at(i);
            const Vector2 p = project_on_disc(trial(k), problem_.bound[i]);
            worst = larger(worst, norm(t - p));
            // A start from other bounds may be close and yet slip below the bound: not accepted.
            on_bound_ = on_bound_ && (norm(trial(k)) <= problem_.bound[i] ||
                                      norm(t) >= problem_.bound[i] * (1 - 1e-11));
            force = force + area_[i] * problem_.tilt.apply(i, t);
        }
        solution_.residual = worst / mean_bound_;
        solution_.force_residual = 0;
        for (int d = 0; d < 2; ++d) {
            missing_force_[d] = force_controlled_[d] ? problem_.control[d].value - force[d] : 0;
            solution_.force_residual =
                larger(solution_.force_residual, std::abs(missing_force_[d]) / total_bound_);
        }
    }

    bool converged() const {
        return on_bound_ && solution_.residual <= tolerance_ &&
               solution_.force_residual <= force_tolerance;
    }

    /// One Newton step on the present zones; false when they cannot carry the force.
    bool solve_linear_system() {
        std::vector<Vector2> tangent(active_.size());
        std::vector<double> curvature(active_.size(), 0.0);
        TangentialField right_hand_side(area_.size());
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            right_hand_side.set(i, slip_[k]);
            if (!slipping_[k]) continue;
            const Vector2 t = traction().at(i);
            const double bound = problem_.bound[i];
            tangent[k] = {-t[1] / bound, t[0] / bound};
            curvature[k] = std::max(0.0, dot(slip_[k], t) / bound) / bound;
        }
        if (!system_->set_zones(slipping_, std::move(tangent), std::move(curvature))) return false;
        const double scale = alpha_ * mean_bound_;
        // Zones still move while the residual is large: solve no more exactly than that deserves.
        const double forcing = std::clamp(std::sqrt(solution_.residual), 1e-3, 0.3);
        // Rotating slipping tractions costs force in the second order: keep the rotations small.
        // The system's residual is a mean, ours a maximum: go finer where that makes the
        // difference.
        const double fine = std::min(tolerance_, 0.01 * std::sqrt(force_tolerance)) *
                            std::pow(0.1, without_progress_);
        const auto& result = system_->solve(
            right_hand_side, missing_force_,
            {.relative = forcing, .absolute = 0.1 * fine * scale, .iterations = cg_iterations});
        solution_.iterations += result.iterations;
        // Where all slip in the direction of the force, hardly any rotation carries more of it.
        const double farthest = 1e3 * (scale + norm(solution_.shift_increment));
        if (!(norm(result.shift_increment) <= farthest)) return false;
        move(result);
        return true;
    }

    void move(const TangentialSystem::Result& result) {
        solution_.shift_increment = solution_.shift_increment + result.shift_increment;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            Vector2 t = traction().at(i) + result.z.at(i);
            if (slipping_[k]) t = onto_edge(t, problem_.bound[i]);
            traction().set(i, t);
            slip_[k] =
                slip_[k] + (problem_.tilt.apply(i, result.shift_increment) - result.a_z.at(i));
        }
    }

    /// New zones from traction and slip; slipping points are put on their friction disc.
    void classify() {
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const std::size_t i = active_[k];
            const double bound = problem_.bound[i];
            const Vector2 y = trial(k);
            slipping_[k] = norm(y) > bound;
            traction().set(
                i, slipping_[k] ? onto_edge(y, bound) : project_on_disc(traction().at(i), bound));
        }
    }

    /// On from where the last ones ended, for Newton's steps since then led nowhere: gradients
    /// alone descend without end.
    void take_gradient_steps() {
        if (gradient_iterations_ > gradient_iterations) {
            traction() = descended_.traction;
            solution_.shift_increment = descended_.shift_increment;
        }
        projected_gradient(compliance_, active_, problem_, gradient_iterations_, solution_);
        gradient_iterations_ = std::min(2 * gradient_iterations_, most_gradient_iterations);
        descended_.traction = traction();
        descended_.shift_increment = solution_.shift_increment;
        update_slip();
    }

    const Compliance& compliance_;
    const std::vector<std::size_t>& active_;
    const ActiveOperator& products_;
    const std::vector<double>& area_;
    const TangentialProblem& problem_;
    const double tolerance_;
    const double alpha_;  // contact compliance [m/Pa]
    TangentialSolution& solution_;
    std::array<bool, 2> force_controlled_{};
    std::vector<std::uint8_t> slipping_;  // per active point
    std::vector<Vector2> slip_;           // s [m] per active point
    std::optional<TangentialSystem> system_;
    Vector2 missing_force_{};
    int without_progress_ = 0;  // Newton steps
    int gradient_iterations_ = gradient_iterations;
    TangentialSolution descended_;  // by gradients
    bool on_bound_ = false;         // all that slip are
    bool shift_is_given_ = false;
    double total_bound_ = 0, active_area_ = 0, mean_bound_ = 0;
};

}  // namespace

TangentialSolver::TangentialSolver(const Compliance& compliance, double tolerance)
    : compliance_(compliance), tolerance_(tolerance) {}

void TangentialSolver::solve(const TangentialProblem& problem, TangentialSolution& solution) {
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < problem.bound.size(); ++i)
        if (problem.bound[i] > 0) active.push_back(i);
    const ActiveOperator& products = products_among(active);
    Newton(compliance_, active_, products, problem, tolerance_, solution).run();
}

const ActiveOperator& TangentialSolver::products_among(const std::vector<std::size_t>& active) {
    if (!products_ || active != active_) {
        products_.reset();
        active_ = active;
        products_ = make_active_operator(compliance_, active_);
    }
    return *products_;
}

}  // namespace tricontact::contact
