// Surfaces that attract each other: normal contact alone, from the last state on.

#include "contact/solvers/staggered_solver.h"

namespace tricontact::contact {

void StaggeredSolver::attract(const Attraction& attraction) {
    adhesive_.emplace(name_, compliance(), attraction, tolerance_);
    release();
}

/// From the last state on: another way to the same load may lead to another state.
void StaggeredSolver::solve_adhesive(const LoadStep& step) {
    now_.normal = std::make_shared<const NormalSolution>(
        adhesive_->follow(update_height(), step.normal, *now_.normal));
    now_.normal_iterations = now_.normal->iterations;
}

}  // namespace tricontact::contact
