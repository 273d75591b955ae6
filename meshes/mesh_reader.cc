#include <fcntl.h>
#include <fmt/format.h>
#include <gmsh.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <system_error>

#include "contact/error.h"
#include "meshes/gmsh_model.h"
#include "meshes/gmsh_session.h"
#include "meshes/mesh_file.h"
#include "meshes/mesh_format.h"
#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

// The file under a name without a past. By its own name gmsh would take a .geo for a script, and
// run a script `path`.opt beside it.
class Nameless {
  public:
    explicit Nameless(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (fd_ < 0)
            fail(path,
                 "the mesh file cannot be opened (" + std::generic_category().message(errno) + ")",
                 "check that it is still there");
    }
    ~Nameless() { ::close(fd_); }
    Nameless(const Nameless&) = delete;
    Nameless& operator=(const Nameless&) = delete;
    std::string path() const { return "/dev/fd/" + std::to_string(fd_); }

  private:
    int fd_;
};

}  // namespace

HexMesh read_mesh(const std::string& path, double unit) {
    if (!(unit > 0) || !std::isfinite(unit))
        fail(path, fmt::format("the unit of length is {:g} m", unit), "make it a positive length");
    check_mesh_file(path);
    HexMesh mesh;
    try {
        const GmshSession session;
        const Nameless file(path);
        GmshSession::call([&] {
            gmsh::merge(file.path());
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
