#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fem/matrices.h"

namespace tricontact::fem {

/// Order in which to eliminate the unknowns of a stiffness: the first `n_interior` ones by METIS'
/// nested dissection of the graph of their nodes, then the others as they are. Entry k is the
/// unknown to come k-th. `node_of_unknown`: see Discretisation. Throws std::bad_alloc.
std::vector<std::int64_t> dissection_order(const SparseMatrix& stiffness,
                                           std::span<const int> node_of_unknown, int n_interior);

}  // namespace tricontact::fem
