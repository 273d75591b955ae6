#pragma once

#include <functional>
#include <memory>

#include "fem/case/model.h"

namespace tricontact::fem {

/// The case, of which not_iterative() finds nothing, on the mesh of `spec` without a factor. Throws
/// contact::InputError where not even that fits the memory, contact::NotConverged.
std::unique_ptr<contact::Model> make_iterative(const contact::Case& c,
                                               const meshes::LayerMeshSpec& spec, int n_threads,
                                               const Say& say);

/// As the case's fem.solver says: that model, or `direct()`; where it is left to the program the
/// iterative one when the memory does not suffice for the other.
std::unique_ptr<contact::Model> by_solver(
    const contact::Case& c, const meshes::LayerMeshSpec& spec, int n_threads, const Say& say,
    const std::function<std::unique_ptr<contact::Model>()>& direct);

}  // namespace tricontact::fem
