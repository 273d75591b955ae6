#include "meshes/mesh_checks.h"
#include "meshes/mesh_file.h"

namespace tricontact::meshes {

void verify(const HexMesh& mesh, const std::string& name) {
    check_elements(mesh, name);
    check_names(mesh, name);
    const FaceTable table(mesh);
    check_coincident_nodes(mesh, table, name);
    check_faces(mesh, table, name);
    check_connected(mesh, table, name);
    check_placement(mesh, table, name);
}

}  // namespace tricontact::meshes
