#pragma once

#include <span>
#include <vector>

#include "fem/body_parts.h"
#include "fem/discretisation.h"
#include "fem/memory.h"
#include "fem/one_blas_thread.h"

namespace tricontact::fem {

/// All of a layer: its discretisation and its stiffness, analysed. Throws contact::InputError,
/// std::bad_alloc.
class WholeBody {
  public:
    explicit WholeBody(const LayerProblem& problem)
        : discretisation(problem), parts_(parts_of(discretisation, Elimination::cheapest)) {}

    /// Displacements [m] under the forces [N] on all unknowns. Most bodies are asked once: factors
    /// are kept from the second time on. Until then it takes as long as a condensation by one
    /// thread; throws contact::NotConverged, std::bad_alloc.
    std::vector<double> displacement(std::span<const double> applied) {
        const FreedMemoryStays stays;
        const OneBlasThread one_thread;
        const std::vector<double> forces = balanced(applied);
        std::vector<double> sum(forces.size(), 0.);
        for (BodyPart& part : parts_) {
            if (!part.condensation.is_factorised()) part.condensation.factorise();
            part.add_displacement(forces, sum);
            if (!was_asked_) part.condensation.forget_factor();
        }
        was_asked_ = true;
        return sum;
    }

    const Discretisation discretisation;

  private:
    /// With the pressure on the base of a body that is pressed evenly.
    std::vector<double> balanced(std::span<const double> applied) const {
        std::vector<double> forces(applied.begin(), applied.end());
        if (discretisation.even_load.empty()) return forces;
        double along_z = 0;
        for (std::size_t u = 0; u < forces.size(); ++u)
            if (discretisation.unknowns.direction_of_unknown[u] == 2) along_z += forces[u];
        for (std::size_t u = 0; u < forces.size(); ++u)
            forces[u] -= along_z * discretisation.even_load[u];
        return forces;
    }

    std::vector<BodyPart> parts_;
    bool was_asked_ = false;
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
