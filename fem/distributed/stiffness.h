#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fem/condensed_layer.h"
#include "fem/contact_surface.h"
#include "fem/distributed/session.h"
#include "meshes/hex_mesh.h"

struct _p_Mat;  // PETSc's Mat and Vec point to these
struct _p_Vec;

namespace tricontact::fem::distributed {

/// The given hexahedra (increasing) of `mesh` as a mesh of their own, with the names of their
/// faces. Faces where it was cut off, and those without a name, are called free_top: nothing holds
/// or loads them.
meshes::HexMesh part_of(const meshes::HexMesh& mesh, std::span<const int> hexes);

/// The stiffness of Discretisation, with its elements and rows distributed over the ranks: the
/// mesh is the coarse mesh of a triangulation that p4est divides along a space-filling curve.
///
/// All displacement components have a row; those held are decoupled from the others.
class Stiffness {
  public:
    /// Collective; `problem` is the same on all ranks. Throws what Discretisation throws, on all.
    Stiffness(const LayerProblem& problem, const Session& session);
    ~Stiffness();

    /// PETSc's matrix [N/m], symmetric positive definite, both triangles.
    _p_Mat* matrix = nullptr;
    /// Per direction, as in AssembledStiffness [N/m].
    std::array<_p_Vec*, 3> held_rows{};
    /// The contact patch of the whole mesh, the same on all ranks but for the nodes' numbers.
    ContactSurface surface;
    /// Row of component c of contact point i at c * n + i, or -1: held. The same on all ranks.
    std::vector<int> contact_rows;
    std::int64_t n_unknowns = 0;  ///< free components

    /// Of the nodes of this rank [m]: three rows each, one after another from the rank's first.
    std::vector<std::array<double, 3>> owned_nodes() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem::distributed
