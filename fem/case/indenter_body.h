#pragma once

#include "contact/case.h"
#include "fem/condensed_layer.h"
#include "meshes/layer_mesh.h"

namespace tricontact::fem {

/// The body of an indenter that deforms, as a substrate of its own whose contact patch matches that
/// of a layer meshed by `patch`. Throws contact::InputError where the body is too small for it.
LayerProblem indenter_problem(const contact::Case& c, const meshes::LayerMeshSpec& patch);

}  // namespace tricontact::fem
