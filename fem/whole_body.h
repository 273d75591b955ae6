#pragma once

#include "fem/condensation.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

/// All of a layer: its discretisation and the factor of its stiffness.
struct WholeBody {
    /// As long as a condensation. Throws contact::InputError, contact::NotConverged.
    explicit WholeBody(const LayerProblem& problem)
        : discretisation(problem),
          condensation(discretisation.assemble().matrix, discretisation.unknowns.node_of_unknown,
                       discretisation.unknowns.n_interior) {
        condensation.factorise();
    }
    Discretisation discretisation;
    Condensation condensation;
};

}  // namespace tricontact::fem
