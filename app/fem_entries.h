#pragma once

#include <memory>
#include <string>

#include "app/commands/cache_command.h"
#include "app/commands/commands.h"
#include "app/models.h"
#include "contact/case.h"
#include "contact/model.h"
#include "meshes/layer_mesh.h"

namespace tricontact::app {

/// What the finite element module offers to the program. It is loaded when first needed: deal.II
/// and what comes with it take longer to load than many a half-space run to compute.
struct FemEntries {
    std::unique_ptr<contact::Model> (*make_model)(const contact::Case& c, const Say& say);
    meshes::LayerMeshSpec (*mesh_spec)(const contact::Case& c, const Say& say);
    void (*mesh_command)(const MeshOptions& options);
    void (*condense_command)(const CondenseOptions& options);
    void (*cache_command)(const CacheOptions& options);
    bool (*another_process_speaks)();
};

/// The module's only symbol.
inline constexpr const char* fem_entries_symbol = "tricontact_fem_entries";
using FemEntriesFunction = const FemEntries*();

/// Loads the module if need be. Throws std::runtime_error when it is not beside the program.
const FemEntries& fem_entries();

}  // namespace tricontact::app
