#pragma once

#include <functional>
#include <memory>
#include <string>

#include "contact/case.h"
#include "contact/model.h"
#include "meshes/layer_mesh.h"

namespace tricontact::fem {

/// Receives one line about what is being done or was decided.
using Say = std::function<void(const std::string&)>;

/// The layer of a case by finite elements. Our own mesh is fitted to contact and path by a coarse
/// layer first; its size is the case's, or follows from the accuracy asked for. Throws
/// contact::InputError (mesh file, memory, ...), contact::NotConverged.
/// `n_threads`: of the iterative solver.
std::unique_ptr<contact::Model> make_model(const contact::Case& c, const Say& say,
                                           int n_threads = 1);

/// The mesh on which make_model computes the case.
meshes::HexMesh make_mesh(const contact::Case& c, const Say& say);
/// What our own mesh of the case is made from; not for a case with a mesh file.
meshes::LayerMeshSpec mesh_spec(const contact::Case& c, const Say& say);

}  // namespace tricontact::fem
