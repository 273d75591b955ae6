#pragma once

#include "fem/patch.h"

namespace tricontact::fem {

/// Element size for the case's fem.accuracy [m]: the layer is pressed on two coarse meshes, and
/// their difference in indentation (or force), peak pressure and unit shift extrapolated with
/// order 1.5, less than is observed. `radius` [m]: of the contact.
double size_for_accuracy(const contact::Case& c, double radius, Workshop& workshop);

/// The layer on the mesh of `spec`. When the memory does not suffice, the error names the size
/// that would.
std::unique_ptr<CondensedCompliance> make_fitting(const contact::Case& c,
                                                  const meshes::LayerMeshSpec& spec,
                                                  Workshop& workshop);

}  // namespace tricontact::fem
