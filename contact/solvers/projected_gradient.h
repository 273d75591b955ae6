#pragma once

#include <vector>

#include "contact/base/vector2.h"
#include "contact/solvers/tangential_solver.h"

namespace tricontact::contact {

/// Accelerated projected gradients with restart (Nesterov 1983; O'Donoghue & Candes 2015) on
/// min 1/2 <t, A t> - <t, u_previous> over friction discs and prescribed total force. Slow, but
/// nothing stops it: the way out when the active set method cycles. Improves `solution` (feasible
/// on return) by `iterations` steps. `products`: the compliance among the `active` points.
void projected_gradient(const Compliance& compliance, const std::vector<std::size_t>& active,
                        const ActiveOperator& products, const TangentialProblem& problem,
                        int iterations, TangentialSolution& solution);

/// Point of the edge of the disc of radius `bound` (Coulomb's friction disc) in the direction of
/// `t`, which is not zero.
inline Vector2 onto_edge(const Vector2& t, double bound) {
    const double factor = bound / norm(t);
    return {t[0] * factor, t[1] * factor};
}

/// Nearest point to `t` in that disc.
inline Vector2 project_on_disc(const Vector2& t, double bound) {
    return norm(t) <= bound ? t : onto_edge(t, bound);
}

}  // namespace tricontact::contact
