#pragma once

#include "contact/case.h"
#include "fem/condensed_layer.h"
#include "meshes/layer_mesh.h"

namespace tricontact::fem {

/// A block along y: all of its face touches, up to sharp edges.
bool is_block(const contact::Case& c);

/// Whether the indenter is a cylinder or ball around a hub that rolls. It turns about the hub, and
/// each of its points meets that point of the other surface which is as far along: pairs of points
/// stay, and in frames of its own points its patch is the same anywhere around the axis. A ball
/// that rolls on is not: of it one cell is meshed, where it stands.
bool rolls_on_its_hub(const contact::Case& c);

/// The body of an indenter that deforms, as a substrate of its own whose contact patch matches that
/// of a layer meshed by `patch`. Throws contact::InputError where the body is too small for it.
LayerProblem indenter_problem(const contact::Case& c, const meshes::LayerMeshSpec& patch);

}  // namespace tricontact::fem
