#include "app/models/fem_entries.h"
#include "app/models/module_loader.h"

namespace tricontact::app {

namespace {

const MeshEntries& mesh_entries() {
    static auto* const entries = reinterpret_cast<MeshEntriesFunction*>(
        module_symbol("meshes of finite elements", MESH_MODULE, mesh_entries_symbol));
    return *entries();
}

const FemEntries& loaded_fem_entries() {
    auto* const function = reinterpret_cast<FemEntriesFunction*>(
        module_symbol("finite elements", FEM_MODULE, fem_entries_symbol));
    const FemEntries& entries = *function();
    entries.load_mesh_entries_by(mesh_entries);
    return entries;
}

}  // namespace

const FemEntries& fem_entries() {
    static const FemEntries& entries = loaded_fem_entries();
    return entries;
}

}  // namespace tricontact::app
