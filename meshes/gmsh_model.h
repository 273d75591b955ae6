#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// gmsh's library, switched on for the lifetime of this object: silent, one thread, no user's
/// configuration, an empty model. There is one library per process: a second session waits for the
/// first. The process's locale, which gmsh changes, is restored, and nothing stays on the disk.
/// Not to be nested. Throws std::runtime_error if gmsh cannot start.
class GmshSession {
  public:
    GmshSession();
    ~GmshSession();
    GmshSession(const GmshSession&) = delete;
    GmshSession& operator=(const GmshSession&) = delete;

    /// Calls gmsh; what it throws becomes a std::runtime_error with gmsh's own message.
    static void call(const std::function<void()>& function);

  private:
    std::unique_lock<std::mutex> lock_;
    std::string locale_;
};

/// Hexahedra and named faces of gmsh's current model, within a GmshSession; nodes, hexahedra and
/// faces in the order of their tags, nodes without a hexahedron left out. `unit` [m] is the length
/// of 1 in the model, `name` what messages call it. Throws contact::InputError: unknown names,
/// hexahedra without one, entities with two, other elements than straight hexahedra.
HexMesh collect_model(double unit, const std::string& name);

/// Tag of the physical group: 1, 2, ... in the order of the enumeration.
template <class What>
int physical_tag(What what) {
    return static_cast<int>(what) + 1;
}

/// Makes an entity for the elements of a name, its tag that of the physical group, in the current
/// model; `What`: Boundary or Region.
template <class What>
void add_entity(What what);

}  // namespace tricontact::meshes
