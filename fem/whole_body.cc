#include "fem/whole_body.h"

#include <utility>

#include "contact/base/error.h"
#include "fem/memory.h"
#include "fem/one_blas_thread.h"

namespace tricontact::fem {

WholeBody::WholeBody(const LayerProblem& problem, const InsideSolverOf& without_factor)
    : discretisation(problem, without_factor ? Elements::bricks_if_all_are : Elements::any) {
    if (without_factor) without_factor_ = without_factor(problem, discretisation);
    if (!without_factor_) parts_ = parts_of(discretisation, Elimination::cheapest);
}

BodyState WholeBody::state(std::span<const double> applied) {
    if (!without_factor_) return by_factor(applied);
    try {
        return without_factor_(applied);
    } catch (const contact::NotConverged&) {
        return by_factor(applied);
    }
}

/// With the pressure on the base of a body that is pressed evenly.
std::vector<double> WholeBody::balanced(std::span<const double> applied) const {
    std::vector<double> forces(applied.begin(), applied.end());
    if (discretisation.even_load.empty()) return forces;
    double along_z = 0;
    for (std::size_t u = 0; u < forces.size(); ++u)
        if (discretisation.unknowns.direction_of_unknown[u] == 2) along_z += forces[u];
    for (std::size_t u = 0; u < forces.size(); ++u)
        forces[u] -= along_z * discretisation.even_load[u];
    return forces;
}

BodyState WholeBody::by_factor(std::span<const double> applied) {
    const FreedMemoryStays stays;
    const OneBlasThread one_thread;
    if (parts_.empty()) parts_ = parts_of(discretisation, Elimination::cheapest);
    const std::vector<double> forces = balanced(applied);
    std::vector<double> sum(forces.size(), 0.);
    for (BodyPart& part : parts_) {
        if (!part.condensation.is_factorised()) part.condensation.factorise();
        part.add_displacement(forces, sum);
        if (!was_asked_) part.condensation.forget_factor();
    }
    was_asked_ = true;
    return {std::move(sum)};
}

}  // namespace tricontact::fem
