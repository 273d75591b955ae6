#include "contact/solvers/tangential_solver.h"

#include <fmt/format.h>

#include "contact/base/error.h"
#include "contact/compliances/blocks.h"
#include "contact/solvers/tangential_newton.h"

namespace tricontact::contact {

namespace {

/// Nothing touches, nothing holds the indenter: it goes where its shifts are prescribed and stays
/// where no force is.
void leave_apart(const TangentialProblem& problem, TangentialSolution& solution) {
    if (const double force = prescribed_force(problem.control); force > 0)
        throw InputError(fmt::format(
            "tangential contact: nothing touches that could carry the force {:.6g} N; prescribe "
            "the shift, or no tangential force while the contact is lost",
            force));
    solution = {};
    solution.traction = solution.displacement = TangentialField(problem.bound.size());
    for (int d = 0; d < 2; ++d)
        if (problem.control[d].kind == TangentialControl::Kind::shift)
            solution.shift_increment[d] = problem.control[d].value;
}

}  // namespace

/// On from where the last ones ended, for Newton's steps since then led nowhere: gradients
/// alone descend without end.
void TangentialNewton::take_gradient_steps() {
    if (gradient_iterations_ > gradient_iterations) {
        solution_.traction = descended_.traction;
        solution_.shift_increment = descended_.shift_increment;
    } else {
        hand_over();
    }
    projected_gradient(compliance_, active_, products_, problem_, gradient_iterations_, solution_);
    gradient_iterations_ = std::min(2 * gradient_iterations_, most_gradient_iterations);
    descended_.traction = solution_.traction;
    descended_.shift_increment = solution_.shift_increment;
    take_over();
    update_slip();
}

TangentialSolver::TangentialSolver(const Compliance& compliance, double tolerance)
    : compliance_(compliance), tolerance_(tolerance) {}

void TangentialSolver::solve(const TangentialProblem& problem, TangentialSolution& solution) {
    const Blocks points(problem.bound.size(), compliance_.n_threads());
    const std::vector<std::size_t> active =
        points.points_where([&](std::size_t i) { return problem.bound[i] > 0; });
    if (active.empty()) return leave_apart(problem, solution);
    const ActiveOperator& products = products_among(active);
    TangentialNewton(compliance_, active_, products, problem, tolerance_, solution).run();
}

const ActiveOperator& TangentialSolver::products_among(const std::vector<std::size_t>& active) {
    if (!products_ || active != active_) {
        products_.reset();
        active_ = active;
        products_ = make_active_operator(compliance_, active_, &memory_);
    }
    return *products_;
}

}  // namespace tricontact::contact
