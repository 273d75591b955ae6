#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fem/body_parts.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

/// State of a body under the forces [N] on all free unknowns, without a factor. May throw
/// contact::NotConverged.
using InsideSolver = std::function<BodyState(std::span<const double> forces)>;
/// Makes one for a body; empty where the body does not suit.
using InsideSolverOf = std::function<InsideSolver(const LayerProblem&, const Discretisation&)>;

/// All of a layer: its discretisation and what solves for its displacements: `without_factor`, or a
/// factor where that does not suit or does not converge.
class WholeBody {
  public:
    /// With `without_factor`, elements of bricks. Throws contact::InputError, std::bad_alloc.
    explicit WholeBody(const LayerProblem& problem, const InsideSolverOf& without_factor = {});

    /// State under the forces [N] on all unknowns. Most bodies are asked once: factors are kept
    /// from the second time on. Until then a factor takes as long as a condensation by one thread;
    /// throws contact::NotConverged, std::bad_alloc.
    BodyState state(std::span<const double> applied);

    const Discretisation discretisation;

  private:
    BodyState by_factor(std::span<const double> applied);
    std::vector<double> balanced(std::span<const double> applied) const;

    InsideSolver without_factor_;
    std::vector<BodyPart> parts_;  // analysed when first needed
    bool was_asked_ = false;       // to solve by factors
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
