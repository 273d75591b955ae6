// Steps in proportion: what moves between indenter and surface before they meet is no slip.

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "contact/solvers/fixed_point.h"
#include "contact/solvers/staggered_solver.h"

namespace tricontact::contact {

/// What separates indenter and surface before the step.
void StaggeredSolver::keep_gap(const LoadStep& step, const StepStart& before) {
    gap_before_.clear();
    before_touch_ = {};
    met_traction_.assign(3, 0);
    met_is_kept_ = false;
    // Contact that jumps in does not grow as the gap closes.
    if (!step.in_proportion || !step.friction || adhesive_) return;
    const NormalSolution& last = *now_.normal;
    if (last.force == 0 && last.indentation == 0) coupling_.place(step.offset);  // first touch
    gap_before_ = large_copy(coupling_.bare_height(), n_threads());
    blocks().for_points(
        [&](std::size_t i) { gap_before_[i] += before.displacement.down[i] - last.indentation; });
}

/// Displacement along over displacement into the surface by equal tractions on a point alone:
/// E*/G*.
double StaggeredSolver::local_ratio() const {
    if (points().local_ratio > 0) return points().local_ratio;
    const auto& pressure = now_.normal->pressure;
    const auto highest = std::ranges::max_element(pressure) - pressure.begin();
    std::vector<double> down(pressure.size()), unit(pressure.size());
    TangentialField along(pressure.size()), displaced(pressure.size());
    unit[highest] = along.x[highest] = 1;
    substrate_.compliance().normal(unit, down);
    substrate_.compliance().tangential(along, displaced);
    const double ratio = displaced.x[highest] / down[highest];
    // A rectangle resists along one side otherwise than along the other: the mean is E*/G* for any.
    // Strips of a line contact have their edges along x alone.
    if (points().spacing[0] == points().spacing[1] || points().line_length > 0) return ratio;
    along.x[highest] = 0;
    along.y[highest] = 1;
    substrate_.compliance().tangential(along, displaced);
    return (ratio + displaced.y[highest] / down[highest]) / 2;
}

/// Tangential traction over pressure where points have been met, as a translation and a rotation
/// about the indenter times `radius` fit it: x, y, rotation.
std::vector<double> StaggeredSolver::traction_ratio(const std::vector<std::size_t>& met,
                                                    double radius) const {
    double force = 0, moment = 0, inertia = 0;
    Vector2 first{}, along{};
    for (const std::size_t i : met) {
        const double part = points().area[i] * now_.normal->pressure[i];
        const Vector2 r{points().x[i] - now_.offset[0], points().y[i] - now_.offset[1]};
        const Vector2 t = points().area[i] * now_.tangential.traction.at(i);
        force += part;
        first = first + part * r;
        inertia += part * dot(r, r);
        along = along + t;
        moment += r[0] * t[1] - r[1] * t[0];
    }
    if (points().mirrored) return {along[0] / force, 0, 0};
    const double own = inertia - dot(first, first) / force;
    const double turned = radius > 0 && own > 0
                              ? (moment - (first[0] * along[1] - first[1] * along[0]) / force) / own
                              : 0;
    return {(along[0] + turned * first[1]) / force, (along[1] - turned * first[0]) / force,
            turned * radius};
}

/// Beside the edge of the contact the gap and what moves along it both grow with the root of the
/// distance, by the intensities of the tractions at the edge, and the tractions of what is met next
/// have the same ones: along the surface a point has missed E*/G* t/p times the gap that has
/// closed. On the half-space, where nothing slips, increments of tangential contact are those of
/// normal contact times a factor (Jaeger 1998, Ciavarella 1998), and this is exact for steps of any
/// length. Of t/p the mean over what is met is taken, which a fixed-point iteration finds: a gain
/// of a factor of 3 at the first touch, where all points are met, and more elsewhere. Where points
/// are barely met it may jump between bounds of friction: then, after some damped iterations, it is
/// kept for this step. What is solved is in equilibrium with any ratio; its error is one of the
/// step's length, of points that carry next to nothing.
void StaggeredSolver::solve_growing(const TangentialProblem& problem, const StepStart& before) {
    constexpr int most_accelerated = 8, most_iterations = 24;
    const auto solve = [&](const TangentialProblem& at) {
        tangential_solver_->solve(at, now_.tangential);
        now_.tangential_iterations += now_.tangential.iterations;
    };
    std::vector<std::size_t> met;
    double widest = 0, radius = 0;
    for (std::size_t i = 0; i < gap_before_.size(); ++i) {
        if (!(now_.bound[i] > 0) || before.traction.down[i] > 0 || !(gap_before_[i] > 0)) continue;
        met.push_back(i);
        widest = std::max(widest, gap_before_[i]);
        if (before.rotation != 0)
            radius = std::max(
                radius, std::hypot(points().x[i] - now_.offset[0], points().y[i] - now_.offset[1]));
    }
    before_touch_ = {};
    if (met.empty()) return solve(problem);
    const double ratio = local_ratio();
    const double mu = friction_ratio();
    const double allowed =
        tolerance_ * looseness_ * mu * std::max(now_.shift_factor, 1.) * now_.normal->length;
    FixedPoint iteration;
    double last_change = infinity, weight = 1;
    for (int k = 1;; ++k) {
        const TangentialField relative = beyond_touch(problem, met, ratio, radius);
        solve({.bound = problem.bound,
               .previous_displacement = relative,
               .control = problem.control,
               .contact_compliance = problem.contact_compliance,
               .looseness = problem.looseness,
               .displaces_all = problem.displaces_all,
               .hardening = problem.hardening});
        const std::vector<double> found = traction_ratio(met, radius);
        double change = 0;
        for (int d = 0; d < 3; ++d)
            change = std::max(change, std::abs(found[d] - met_traction_[d]));
        met_is_kept_ = met_is_kept_ || k == most_iterations;
        if (met_is_kept_ || ratio * widest * change <= allowed) return;
        if (k <= most_accelerated) {
            met_traction_ = iteration.next(met_traction_, found, change);
        } else {
            if (change > .9 * last_change) weight /= 2;
            for (int d = 0; d < 3; ++d) met_traction_[d] += weight * (found[d] - met_traction_[d]);
        }
        last_change = change;
        for (double& part : met_traction_) part = std::clamp(part, -mu, mu);
    }
}

/// What was displaced before, where points have been met together with what moved before that.
TangentialField StaggeredSolver::beyond_touch(const TangentialProblem& problem,
                                              const std::vector<std::size_t>& met, double ratio,
                                              double radius) {
    before_touch_ = TangentialField(gap_before_.size(), n_threads());
    TangentialField relative = problem.previous_displacement;
    const double turned = radius > 0 ? met_traction_[2] / radius : 0;
    for (const std::size_t i : met) {
        const Vector2 along{met_traction_[0] - turned * (points().y[i] - now_.offset[1]),
                            met_traction_[1] + turned * (points().x[i] - now_.offset[0])};
        before_touch_.set(i, (ratio * gap_before_[i]) * along);
        relative.set(i, relative.at(i) - substrate_.stiffness() * before_touch_.at(i));
    }
    return relative;
}

}  // namespace tricontact::contact
