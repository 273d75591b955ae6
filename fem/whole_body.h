#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fem/block/block_solver.h"
#include "fem/body_parts.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

/// All of a layer: its discretisation and what solves for its displacements.
class WholeBody {
  public:
    enum class Solution : std::uint8_t {
        factor,
        block,  ///< by iteration where the body is a block that its tractions alone load
    };
    /// Throws contact::InputError, std::bad_alloc.
    explicit WholeBody(const LayerProblem& problem, Solution solution = Solution::factor);

    /// Displacements [m] under the forces [N] on all unknowns. Most bodies are asked once: factors
    /// are kept from the second time on. Until then a factor takes as long as a condensation by one
    /// thread; throws contact::NotConverged, std::bad_alloc.
    std::vector<double> displacement(std::span<const double> applied);

    const Discretisation discretisation;

  private:
    struct Block {
        Block(const Discretisation& body, const BlockGrid& grid);
        std::vector<double> displacement(std::span<const double> forces);

        BlockSolver solver;
        std::vector<std::size_t> places;  ///< of unknowns
    };
    static std::optional<Block> block_of(const LayerProblem& problem, const Discretisation& body);
    std::vector<double> balanced(std::span<const double> applied) const;
    std::vector<double> by_factor(std::span<const double> applied);

    std::optional<Block> block_;
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
