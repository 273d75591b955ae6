#pragma once

#include "fem/whole_body.h"

namespace tricontact::fem {

/// Of a body that is a block and that its tractions alone load, by BlockSolver, with one thread.
InsideSolver block_inside_solver(const LayerProblem& problem, const Discretisation& body);

}  // namespace tricontact::fem
