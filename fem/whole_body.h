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

/// The same for corrections.
struct CorrectedBody {
    /// As WholeBody.
    explicit CorrectedBody(const LayerProblem& problem)
        : discretisation(problem), factor(single_factor(discretisation)) {}
    Discretisation discretisation;
    SingleFactor factor;

  private:
    static SingleFactor single_factor(const Discretisation& discretisation) {
        Condensation condensation(discretisation.assemble().matrix,
                                  discretisation.unknowns.node_of_unknown,
                                  discretisation.unknowns.n_interior);
        condensation.factorise();
        return condensation.single();
    }
};

}  // namespace tricontact::fem
