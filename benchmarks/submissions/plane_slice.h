#pragma once

#include <optional>
#include <vector>

#include "benchmarks/submissions/mesh_data.h"

namespace tricontact::benchmarks {

/// Whether all nodes stand at angles of -1, 0 and 1 degree about the y axis: what CalculiX makes of
/// axisymmetric elements.
bool is_wedge_of_two_degrees(const std::vector<MeshData>& meshes);
/// The face at +1 degree as a plane mesh of r and y; vectors and stresses turned into that plane.
MeshData collapsed_wedge(const MeshData& mesh);

/// Marks a plane mesh as axisymmetric where the coordinates z are what CalculiX' expansion leaves,
/// x cos(pi/2) in double precision; z becomes 0.
void flatten(MeshData& mesh);

/// A mesh with one layer of elements between two planes z = const as the plane mesh at the upper
/// one: what CalculiX makes of elements of plane strain; its contact pressures (CPRESS) stand at
/// its rim. Empty if it is none.
std::optional<MeshData> collapsed_slice(const MeshData& mesh);

}  // namespace tricontact::benchmarks
