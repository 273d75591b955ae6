#pragma once

#include <span>
#include <vector>

#include "fem/body_parts.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

/// All of a layer: its discretisation and the factors of its stiffness. Made as long as a
/// condensation; throws contact::InputError, contact::NotConverged, std::bad_alloc.
class WholeBody {
  public:
    explicit WholeBody(const LayerProblem& problem)
        : discretisation(problem), parts_(parts_of(discretisation, Elimination::cheapest)) {
        for (BodyPart& part : parts_) part.condensation.factorise();
    }

    /// Displacements [m] under the forces [N] on all unknowns.
    std::vector<double> displacement(std::span<const double> forces) const {
        std::vector<double> sum(forces.size(), 0.);
        for (const BodyPart& part : parts_) part.add_displacement(forces, sum);
        return sum;
    }

    const Discretisation discretisation;

  private:
    std::vector<BodyPart> parts_;
};

/// All of a layer, for corrections.
struct CorrectedBody {
    explicit CorrectedBody(const LayerProblem& problem)
        : discretisation(problem), factor(single_factor(discretisation)) {}
    Discretisation discretisation;
    SingleFactor factor;

  private:
    static SingleFactor single_factor(const Discretisation& layer) {
        Condensation condensation(layer.assemble().matrix, layer.unknowns.node_of_unknown,
                                  layer.unknowns.n_interior);
        condensation.factorise();
        return condensation.single();
    }
};

}  // namespace tricontact::fem
