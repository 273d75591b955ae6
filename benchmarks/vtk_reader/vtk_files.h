#pragma once

#include <string>

#include "benchmarks/submissions/mesh_stream.h"

namespace tricontact::benchmarks {

/// Reads the last state of a file by VTK, by its ending: .vtu .vtp .pvtu .pvtp .vts .vtr .vti .vtm,
/// .pvd, .vtk, .e .ex2 .exo, .case, .cgns, .vtkhdf .hdf. Throws std::runtime_error.
MeshAnswer read_by_vtk(const std::string& path);

}  // namespace tricontact::benchmarks
