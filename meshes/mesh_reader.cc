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

namespace {

files::RegularFile open_mesh(const std::string& path) {
    try {
        return files::RegularFile(path);
    } catch (const files::Unreadable& why) {
        refuse_mesh_file(path, why);
    }
}

// The file under a name without a past. By its own name gmsh would take a .geo for a script, and
// run a script `path`.opt beside it; and it might be another file by now.
std::string nameless(const files::RegularFile& file) {
    return "/dev/fd/" + std::to_string(file.descriptor());
}

}  // namespace

HexMesh read_mesh(const std::string& path, double unit) {
    if (!(unit > 0) || !std::isfinite(unit))
        fail(path, fmt::format("the unit of length is {:g} m", unit), "make it a positive length");
    files::RegularFile file = open_mesh(path);
    check_mesh_file(file, path);
    HexMesh mesh;
    try {
        const GmshSession session;
        GmshSession::call([&] {
            gmsh::merge(nameless(file));
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
