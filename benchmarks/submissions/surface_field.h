#pragma once

#include <string>

#include "benchmarks/submissions/mesh_data.h"
#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Whether an array of the mesh is a pressure, a traction or a nodal force that is not zero
/// everywhere.
bool has_contact_values(const MeshData& mesh);

/// Adds to the field what the surface in contact carries: of a body the faces of its boundary whose
/// corners carry a pressure, traction or nodal force, and what continues them smoothly; without
/// such values, but with stresses, the faces that are highest. Cells of a surface are taken as they
/// are. Axes are named so that z is normal to the surface: in a plane or axisymmetric mesh y
/// becomes z. Values at cells stand at their centres with areas. Returns the letters of the file's
/// axes, "xzy" where y is read as z. Throws contact::InputError.
std::string add_surface(MeshField& field, const MeshData& mesh, const std::string& place);

}  // namespace tricontact::benchmarks
