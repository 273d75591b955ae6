#include "meshes/mesh_file.h"

#include <fmt/format.h>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "meshes/messages.h"
#include "meshes/msh_file.h"
#include "meshes/msh_model.h"

namespace tricontact::meshes {

HexMesh read_mesh(const std::string& path, double unit) {
    if (!contact::is_positive_and_finite(unit))
        fail(path, fmt::format("the unit of length is {:g} m", unit), "make it a positive length");
    MshFile file;
    open_msh_file(path, file);
    HexMesh mesh = mesh_of(read_msh_model(file), unit, path);
    verify(mesh, path);
    return mesh;
}

}  // namespace tricontact::meshes
