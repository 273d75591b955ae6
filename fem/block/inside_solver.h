#pragma once

#include "fem/block/mixed_operator.h"
#include "fem/whole_body.h"

namespace tricontact::fem {

/// Of a body that is a block and that its tractions alone load, by BlockSolver, with one thread.
InsideSolver block_inside_solver(const LayerProblem& problem, const Discretisation& body);

/// A body's state of the unknowns x of the block that it is: see places_in_block(),
/// elements_in_block().
BodyState state_in_block(const MixedOperator& mixed, std::span<const double> x,
                         std::span<const std::size_t> places,
                         std::span<const std::size_t> elements);

}  // namespace tricontact::fem
