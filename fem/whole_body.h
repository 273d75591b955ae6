#pragma once

#include <memory>

#include "fem/condensation.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

/// The factor of a layer's stiffness. Throws contact::NotConverged, std::bad_alloc.
inline std::unique_ptr<const Condensation> factorised(const Discretisation& layer) {
    auto condensation = std::make_unique<Condensation>(
        layer.assemble().matrix, layer.unknowns.node_of_unknown, layer.unknowns.n_interior);
    condensation->factorise();
    return condensation;
}

/// All of a layer: its discretisation and the factor of its stiffness. Made as long as a
/// condensation; throws contact::InputError, contact::NotConverged.
struct WholeBody {
    explicit WholeBody(const LayerProblem& problem)
        : discretisation(problem), condensation(factorised(discretisation)) {}
    Discretisation discretisation;
    std::unique_ptr<const Condensation> condensation;
};

/// The same for corrections.
struct CorrectedBody {
    explicit CorrectedBody(const LayerProblem& problem)
        : discretisation(problem), factor(factorised(discretisation)->single()) {}
    Discretisation discretisation;
    SingleFactor factor;
};

}  // namespace tricontact::fem
