#include "rolling/steady_newton.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/friction/friction_disc.h"
#include "contact/substrates/substrate.h"

// Bounds b(s) that follow from the slip: a slipping point has |t| = b(s) in place of a given bound.
// Its traction moves along the direction e of its slip as well, by
//
//   z_e = b(s) - |t| + db,   db = b'(s) ds_e + c db_ahead,   ds = -(M z - w),
//
// c what is left of the memory of the point ahead (SteadySystem::set_following).

namespace tricontact::rolling {

namespace {

using contact::norm;
using contact::operator+, contact::operator-, contact::operator*, contact::operator/;
using contact::TangentialField;
using contact::Vector2;

constexpr double much_grown = 4, halved = .5;  // a residual
constexpr double coarse = 1e-4;                // a tolerance: of a state to go on from

std::vector<std::size_t> points_in_contact(const std::vector<double>& bound) {
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < bound.size(); ++i)
        if (bound[i] > 0) active.push_back(i);
    return active;
}

}  // namespace

SteadyNewton::SteadyNewton(const contact::Compliance& compliance, const SteadyProblem& problem,
                           const SteadyTolerances& tolerances, SteadySolution& solution,
                           const FollowingBound* following)
    : compliance_(compliance),
      points_(compliance.points()),
      problem_(problem),
      following_(following),
      tolerances_(tolerances),
      solution_(solution),
      active_(points_in_contact(problem.bound)),
      force_controlled_{!problem.drive.creepage[0], !problem.drive.creepage[1]},
      own_inverse_(compliance),
      system_(compliance, active_, force_controlled_,
              problem.stick_inverse ? *problem.stick_inverse : own_inverse_),
      alpha_(system_.local()),
      bound_(problem.bound),
      slipping_(active_.size()) {
    for (const std::size_t i : active_) total_bound_ += points_.area[i] * problem_.bound[i];
    check_force_is_carried();
    for (const std::size_t i : active_) mean_bound_ += problem_.bound[i] / active_.size();
    // On half-spaces both are of one size.
    constexpr double alike = 4;
    const double alone = alpha_ * mean_bound_;
    if (problem.slip_unit > 0 && alone > alike * problem.slip_unit)
        tolerances_.residual *= alike * problem.slip_unit / alone;
}

void SteadyNewton::run(int most_steps) {
    start();
    if (active_.empty()) return;
    double first = 0;
    for (int step = 0; step < most_steps; ++step) {
        update_slip();
        classify();
        update_slip();
        update_residual();
        if (is_solved()) return;
        // Beyond the reach of the slopes: on a state's own side the residual may grow once.
        if (step == 0) first = solution_.residual;
        if (following_ && !(solution_.residual <= (step < 2 ? much_grown : halved) * first)) break;
        move(solve_linear_system(step < careful_steps ? .5 : 10));
    }
    throw contact::NotConverged(fmt::format(
        "steady rolling: residual {:.2e} (tolerance {:.1e}), force residual {:.2e} after {} "
        "Newton steps; {} points in contact, {} slipping; creepage {:.3e}, {:.3e}",
        solution_.residual, tolerances_.residual, solution_.force_residual, most_steps,
        active_.size(), std::ranges::count(slipping_, 1), solution_.creepage.longitudinal,
        solution_.creepage.lateral));
}

bool SteadyNewton::is_solved() const {
    return solution_.residual <= tolerances_.residual && bound_residual_ <= tolerances_.residual &&
           solution_.force_residual <= tolerances_.force;
}

std::vector<double> SteadyNewton::left() const {
    std::vector<double> left = following_->left(solution_);
    for (std::size_t k = 0; k < active_.size(); ++k)
        if (slipping_[k])
            left[active_[k]] = norm(solution_.traction.at(active_[k])) / problem_.bound[active_[k]];
    return left;
}

/// t + s/alpha: inside the friction disc where the point sticks.
Vector2 SteadyNewton::trial(std::size_t i) const {
    return solution_.traction.at(i) + solution_.slip.at(i) / alpha_;
}

void SteadyNewton::check_force_is_carried() const {
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

void SteadyNewton::start() {
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
void SteadyNewton::set_sliding_creepage() {
    const TangentialField by_pressure = forward_gradient(points_, active_, problem_.displacement);
    double sliding = 0;
    for (const std::size_t i : active_)
        sliding = std::max(sliding, std::hypot(by_pressure.x[i], by_pressure.y[i]) +
                                        std::abs(problem_.drive.spin) *
                                            std::hypot(points_.x[i] - problem_.centre[0],
                                                       points_.y[i] - problem_.centre[1]));
    sliding_creepage_ = alpha_ * mean_bound_ + sliding;
}

/// And the bounds that follow from it.
void SteadyNewton::update_slip() {
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
    if (!following_) return;
    const std::vector<double> left = following_->left(solution_);
    for (const std::size_t i : active_) bound_[i] = left[i] * problem_.bound[i];
}

void SteadyNewton::update_residual() {
    double worst = 0;
    Vector2 force{};
    bound_residual_ = 0;
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        const Vector2 t = solution_.traction.at(i);
        const Vector2 p = contact::project_on_disc(trial(i), bound_[i]);
        worst = contact::larger(worst, norm(t - p));
        force = force + points_.area[i] * t;
        if (following_ && slipping_[k])
            bound_residual_ =
                contact::larger(bound_residual_, std::abs(norm(t) - bound_[i]) / problem_.bound[i]);
    }
    solution_.residual = worst / mean_bound_;
    solution_.force_residual = 0;
    for (int d = 0; d < 2; ++d) {
        missing_force_[d] = force_controlled_[d] ? problem_.drive.force[d] - force[d] : 0;
        solution_.force_residual =
            contact::larger(solution_.force_residual, std::abs(missing_force_[d]) / total_bound_);
    }
}

/// One Newton step on the present zones; `farthest`: how far the creepage may go, over the
/// sliding one, before it is held back.
SteadySystem::Result SteadyNewton::solve_linear_system(double farthest) {
    std::vector<Vector2> tangent(active_.size());
    std::vector<double> curvature(active_.size(), 0.0);
    for (std::size_t k = 0; k < active_.size(); ++k) {
        if (!slipping_[k]) continue;
        const Vector2 t = solution_.traction.at(active_[k]), s = solution_.slip.at(active_[k]);
        const double bound = following_ ? norm(t) : bound_[active_[k]];
        tangent[k] = {-t[1] / bound, t[0] / bound};
        curvature[k] = std::max(0.0, contact::dot(s, t) / bound) / bound;
    }
    // Zones still move while the residual is large, and a step leaves about its square: solve no
    // more exactly than that deserves, nor than the tolerances ask for; where these are coarse a
    // step shall just reach them.
    const bool is_coarse = tolerances_.residual > coarse;
    const double asked = std::min(tolerances_.residual / solution_.residual,
                                  tolerances_.force / solution_.force_residual);
    const double forcing = std::clamp(
        std::max({solution_.residual, solution_.force_residual, (is_coarse ? .6 : .3) * asked}),
        1e-10, is_coarse ? .6 : .1);
    if (following_) follow();
    SteadySystem::Result result;
    for (const double relief : {0., 1.}) {
        system_.set_zones(slipping_, tangent, curvature, relief);
        result = system_.solve(solution_.slip, missing_force_, forcing);
        solution_.iterations += result.iterations;
        if (norm(result.creepage) <= farthest * sliding_creepage_) break;
    }
    return result;
}

/// Tells the system how bounds follow.
void SteadyNewton::follow() {
    const BoundSlopes all = following_->slopes(solution_);
    const std::size_t m = active_.size();
    SteadySystem::Following f{std::vector<double>(m), std::vector<double>(m),
                              std::vector<double>(m)};
    for (std::size_t k = 0; k < m; ++k) {
        const std::size_t i = active_[k];
        if (slipping_[k]) {
            f.missing[k] = bound_[i] - norm(solution_.traction.at(i));
            f.own[k] = all.own[i] * problem_.bound[i];
        }
        const bool is_row = k + 1 < m && active_[k + 1] == i + 1;
        // Of the bound ahead, in proportion to both.
        if (is_row) f.ahead[k] = all.ahead[i] * problem_.bound[i] / problem_.bound[i + 1];
    }
    system_.set_following(std::move(f));
}

void SteadyNewton::move(const SteadySystem::Result& result) {
    solution_.creepage.longitudinal += result.creepage[0];
    solution_.creepage.lateral += result.creepage[1];
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        const Vector2 before = solution_.traction.at(i), z = result.z.at(i);
        if (!slipping_[k]) {
            solution_.traction.set(i, before + z);
            continue;
        }
        double length = bound_[i];
        if (following_) {
            const double now = norm(before);
            length = std::clamp(now + contact::dot(before, z) / now, .3 * now, problem_.bound[i]);
        }
        solution_.traction.set(i, contact::onto_edge(before + z, length));
    }
}

/// New zones from traction and slip; slipping points are put on their friction disc.
void SteadyNewton::classify() {
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        const Vector2 y = trial(i), t = solution_.traction.at(i);
        slipping_[k] = norm(y) > bound_[i];
        solution_.traction.set(i, contact::project_on_disc(slipping_[k] ? y : t, bound_[i]));
    }
}

}  // namespace tricontact::rolling
