#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>

#include "contact/error.h"
#include "meshes/gmsh_model.h"
#include "meshes/gmsh_session.h"
#include "meshes/mesh_file.h"
#include "meshes/mesh_format.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

HexMesh read_mesh(const std::string& path, double unit) {
    if (!(unit > 0) || !std::isfinite(unit))
        fail(path, fmt::format("the unit of length is {:g} m", unit), "make it a positive length");
    check_mesh_file(path);
    HexMesh mesh;
    try {
        const GmshSession session;
        // merge, not open: open would also run a script `path`.opt.
        GmshSession::call([&] {
            gmsh::merge(path);
            mesh = collect_model(unit, path);
        });
    } catch (const contact::InputError&) {
        throw;
    } catch (const std::exception& error) {
        fail(path, fmt::format("the mesh is damaged ({})", error.what()), "save it again");
    }
    verify(mesh, path);
    return mesh;
}

}  // namespace tricontact::meshes
