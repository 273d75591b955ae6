#pragma once

#include <vector>

#include "contact/solvers/tangential_solver.h"

namespace tricontact::contact {

/// Accelerated projected gradients with restart (Nesterov 1983; O'Donoghue & Candes 2015) on
/// min 1/2 <t, A t> - <t, u_previous> over friction discs and prescribed total force. Slow, but
/// nothing stops it: the way out when the active set method cycles. Improves `solution` (feasible
/// on return) by `iterations` steps. `products`: the compliance among the `active` points.
void projected_gradient(const Compliance& compliance, const std::vector<std::size_t>& active,
                        const ActiveOperator& products, const TangentialProblem& problem,
                        int iterations, TangentialSolution& solution);

}  // namespace tricontact::contact
