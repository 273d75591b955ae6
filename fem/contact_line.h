#pragma once

#include "fem/condensed_layer.h"

namespace tricontact::fem {

/// The contact of a slice in plane strain (meshes::LayerMeshSpec::plane_strain) under tractions
/// that are uniform along y: a grid of one row of points in y = 0, whose areas are those of all
/// rows, as long as both halves of the slice. Displacements are the means over y; along y there are
/// none, and those components are held. Row sums of the surface mass carry a uniform traction
/// exactly, so nothing is lost by the means. There is no contact mass: a line has no element
/// surface.
CondensedLayer contact_line(const CondensedLayer& slice);

}  // namespace tricontact::fem
