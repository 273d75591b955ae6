#include "app/models/mesh_entries.h"
#include "fem/deal_ii/q2_elements.h"
#include "meshes/mesh_file.h"

extern "C" const tricontact::app::MeshEntries* tricontact_mesh_entries() {
    using namespace tricontact;
    static const app::MeshEntries entries = {
        fem::deal_ii::q2_elements,
        meshes::write_mesh,
        fem::distributed::condense_together,
    };
    return &entries;
}
