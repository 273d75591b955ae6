#pragma once

#include <string>
#include <vector>

#include "benchmarks/submissions/mesh_data.h"

namespace tricontact::benchmarks {

/// Whether VTK reads files of this ending: ".vtu".
bool is_vtk_ending(const std::string& ending);

/// Meshes of the last state of a file, read by VTK in a process of its own. Throws
/// contact::InputError.
std::vector<MeshData> read_vtk(const std::string& path, std::vector<std::string>& notes);

}  // namespace tricontact::benchmarks
