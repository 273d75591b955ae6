#pragma once

#include <memory>
#include <string>

#include "app/models/fem_entries.h"
#include "fem/distributed/condense_together.h"
#include "fem/q2_space.h"
#include "meshes/hex_mesh.h"

namespace tricontact::app {

/// What deal.II, gmsh, PETSc and MPI do for the finite element module. They take longer to load
/// than a section, or a layer that is kept, to compute: hence a module of their own.
struct MeshEntries {
    std::unique_ptr<const fem::Q2Elements> (*q2_elements)(const meshes::HexMesh& mesh,
                                                          fem::Q2Space& space);
    void (*write_mesh)(const meshes::HexMesh& mesh, const std::string& path);
    void (*condense_together)(const fem::distributed::SharedOrder& order);
};

}  // namespace tricontact::app
