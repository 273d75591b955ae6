// Steps in proportion: what the indenter meets on the way is carried along from then on.

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
    carried_.clear();
    if (!step.in_proportion || !step.friction) return;
    const NormalSolution& last = *now_.normal;
    if (last.force == 0 && last.indentation == 0) coupling_.place(step.offset);  // first touch
    gap_before_ = large_copy(coupling_.bare_height(), n_threads());
    blocks().for_points(
        [&](std::size_t i) { gap_before_[i] += before.displacement.down[i] - last.indentation; });
}

/// Loads change in proportion: displacements of the surface in all directions do, as far as nothing
/// slips (Jaeger 1998, Ciavarella 1998: each increment of tangential contact is one of normal
/// contact times a factor). What the normal displacement of a point misses of the indenter's
/// approach, the gap before, the tangential one misses of its shift, in the same ratio.
void StaggeredSolver::find_carried(const StepStart& before) {
    if (gap_before_.empty()) return;
    const std::vector<double>& height = coupling_.bare_height();
    const double depth = now_.normal->indentation;
    carried_.assign(height.size(), 1);
    blocks().for_points([&](std::size_t i) {
        if (!(now_.bound[i] > 0) || before.traction.down[i] > 0 || !(gap_before_[i] > 0)) return;
        const double pressed = depth - height[i] - before.displacement.down[i];
        carried_[i] = pressed > 0 ? pressed / (gap_before_[i] + pressed) : 1;
    });
}

/// Where points are carried by a share of the step only, what the rest moves them is known when the
/// shift is: a fixed-point iteration that gains a factor of 3 at the first touch, where all points
/// are met, and more elsewhere.
void StaggeredSolver::solve_carried(const TangentialProblem& problem) {
    constexpr int most_iterations = 100;
    const auto solve = [&](const TangentialProblem& at) {
        tangential_solver_->solve(at, now_.tangential);
        now_.tangential_iterations += now_.tangential.iterations;
    };
    if (std::ranges::all_of(carried_, [](double share) { return share == 1; }))
        return solve(problem);
    const TangentialField& whole = problem.previous_displacement;
    const double unit = friction_coefficient_ * std::max(now_.shift_factor, 1.) *
                        substrate_.stiffness() * now_.normal->length;
    std::vector<double> shift(2);
    for (int d = 0; d < 2; ++d)
        shift[d] = problem.control[d].kind == TangentialControl::Kind::shift
                       ? problem.control[d].value
                       : now_.tangential.shift_increment[d];
    FixedPoint iteration;
    for (int k = 1; k <= most_iterations; ++k) {
        TangentialField met = whole;
        blocks().for_points([&](std::size_t i) {
            met.set(i, whole.at(i) - (1 - carried_[i]) * Vector2{shift[0], shift[1]});
        });
        solve({.bound = problem.bound,
               .previous_displacement = met,
               .control = problem.control,
               .contact_compliance = problem.contact_compliance,
               .looseness = problem.looseness,
               .displaces_all = problem.displaces_all});
        const Vector2 found = now_.tangential.shift_increment;
        const double change = std::hypot(found[0] - shift[0], found[1] - shift[1]);
        if (change <= tolerance_ * looseness_ * unit) return;
        shift = iteration.next(shift, {found[0], found[1]}, change);
    }
    throw NotConverged(
        fmt::format("{}: the shift of a contact that grows is not found after {} "
                    "solutions of its friction",
                    name_, most_iterations));
}

}  // namespace tricontact::contact
