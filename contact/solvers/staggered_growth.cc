// Steps in proportion: what moves between indenter and surface before they meet is no slip.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "contact/solvers/fixed_point.h"
#include "contact/solvers/staggered_solver.h"

namespace tricontact::contact {

/// What separates indenter and surface before the step.
void StaggeredSolver::keep_gap(const LoadStep& step, const StepStart& before) {
    gap_before_.clear();
    before_touch_ = {};
    if (!step.in_proportion || !step.friction) return;
    const NormalSolution& last = *now_.normal;
    if (last.force == 0 && last.indentation == 0) coupling_.place(step.offset);  // first touch
    gap_before_ = large_copy(coupling_.bare_height(), n_threads());
    blocks().for_points(
        [&](std::size_t i) { gap_before_[i] += before.displacement.down[i] - last.indentation; });
}

/// Displacement along over displacement into the surface by equal tractions on a point alone:
/// E*/G*.
double StaggeredSolver::local_ratio() const {
    const auto& pressure = now_.normal->pressure;
    const auto highest = std::ranges::max_element(pressure) - pressure.begin();
    std::vector<double> down(pressure.size()), unit(pressure.size());
    TangentialField along(pressure.size()), displaced(pressure.size());
    unit[highest] = along.x[highest] = 1;
    substrate_.compliance().normal(unit, down);
    substrate_.compliance().tangential(along, displaced);
    return displaced.x[highest] / down[highest];
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
/// of a factor of 3 at the first touch, where all points are met, and more elsewhere.
void StaggeredSolver::solve_growing(const TangentialProblem& problem, const StepStart& before) {
    constexpr int most_iterations = 100;
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
    const double allowed = tolerance_ * looseness_ * friction_coefficient_ *
                           std::max(now_.shift_factor, 1.) * now_.normal->length;
    std::vector<double> traction(3, 0);
    FixedPoint iteration;
    for (int k = 1; k <= most_iterations; ++k) {
        before_touch_ = TangentialField(gap_before_.size(), n_threads());
        TangentialField relative = problem.previous_displacement;
        for (const std::size_t i : met) {
            const double turned = radius > 0 ? traction[2] / radius : 0;
            const Vector2 along{traction[0] - turned * (points().y[i] - now_.offset[1]),
                                traction[1] + turned * (points().x[i] - now_.offset[0])};
            before_touch_.set(i, (ratio * gap_before_[i]) * along);
            relative.set(i, relative.at(i) - substrate_.stiffness() * before_touch_.at(i));
        }
        solve({.bound = problem.bound,
               .previous_displacement = relative,
               .control = problem.control,
               .contact_compliance = problem.contact_compliance,
               .looseness = problem.looseness,
               .displaces_all = problem.displaces_all});
        const std::vector<double> found = traction_ratio(met, radius);
        double change = 0;
        for (int d = 0; d < 3; ++d) change = std::max(change, std::abs(found[d] - traction[d]));
        if (ratio * widest * change <= allowed) return;
        traction = iteration.next(traction, found, change);
    }
    throw NotConverged(
        fmt::format("{}: the tractions of a contact that grows are not found after "
                    "{} solutions of its friction",
                    name_, most_iterations));
}

}  // namespace tricontact::contact
