#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/compliances/interior.h"
#include "fem/condensed_layer.h"
#include "fem/contact_surface.h"
#include "fem/element.h"
#include "fem/matrices.h"
#include "fem/settings.h"

namespace tricontact::fem {

/// Numbering of the free displacement components: interior first, then the contact patch, there x
/// of all nodes, then y, then z.
struct Unknowns {
    int n = 0, n_interior = 0;
    std::vector<std::array<int, 3>> of_node;                 ///< per node and direction; -1: held
    std::vector<int> node_of_unknown, direction_of_unknown;  ///< 0 x, 1 y, 2 z
    std::vector<int> of_contact;  ///< of component c of contact point i at c * n + i, less
                                  ///< n_interior; -1: held
};

/// Bit c: displacement c is held: at the base (bonded: all, frictionless: z), fixed sides (all),
/// the symmetry plane (y).
using Directions = std::uint8_t;
Directions held_on(meshes::Boundary boundary, contact::Case::Base base, Sides sides);
/// Throws contact::InputError when rigid motions remain with a base or sides in the mesh or not.
void refuse_rigid_motions(bool has_base, bool has_sides, contact::Case::Base base, Sides sides);

struct AssembledStiffness {
    SparseMatrix matrix;  ///< between the free unknowns, lower triangle [N/m]
    /// Per direction: the sum of K u over all held components of that direction is the dot product
    /// of u with this [N/m].
    std::array<std::vector<double>, 3> held_rows;
};

/// Displacements of the free unknowns [m] and, where the mixed form was solved, what it has beside:
/// without them the rounding of displacements is multiplied by K.
struct BodyState {
    std::vector<double> displacement;
    /// K times the projected volumetric strain [Pa] of each cell, a brick: coefficients of
    /// {1, xi, eta, zeta}, which go from -1 to 1 along x, y, z. Or none.
    std::vector<std::array<double, 4>> pressure = {};
    std::array<double, 3> held_forces{};  ///< see Discretisation::held_forces; with `pressure` [N]
};

/// Q2 displacements with a discontinuous linear pressure eliminated per element: the volumetric
/// strain is projected onto {1, x, y, z} of each element, so that K may be huge (Brezzi and Fortin
/// 1991, Q2/P1; no locking, no checkerboard). The stiffness is symmetric positive definite.
///
/// Free unknowns only: interior ones first, those of the contact patch last, there ordered as
/// x of all contact nodes, then y, then z; held components (base, sides, symmetry plane) have none.
struct Discretisation {
    /// Throws contact::InputError when the mesh leaves rigid motions free, has no contact, or
    /// boundary faces without a name.
    explicit Discretisation(const LayerProblem& problem, Elements elements = Elements::any);

    /// Recomputed by each call: the largest part of a discretisation, often needed but once.
    AssembledStiffness assemble() const;
    /// That of some cells between some of their unknowns.
    AssembledStiffness assemble(const Unknowns& of_cells, std::span<const int> cells) const;
    /// Sum over all held components of K u in each direction: the force of what holds them [N], for
    /// the displacement of every node [m].
    using NodalDisplacement = std::vector<std::array<double, 3>>;
    std::array<double, 3> held_forces(const NodalDisplacement& displacement) const;
    /// Points and hexahedra of the inside, at rest, without stresses.
    contact::Interior undeformed() const;
    /// Fields inside for the displacements [m] of all free unknowns under the forces [N] on them;
    /// of a body pressed evenly those without the pressure on its base.
    /// Points on the interface of two regions appear once for each. Stresses come from the
    /// 2 x 2 x 2 Gauss points, where those of Q2 elements are most accurate (Barlow 1976), linearly
    /// extrapolated to the nodes and averaged over the elements of a region.
    contact::Interior interior(const BodyState& state, std::span<const double> force) const;

    Q2Space space;
    std::array<Moduli, meshes::n_regions> moduli{};
    ContactSurface surface;
    Unknowns unknowns;
    /// Per node, what holds the base of a body for displacements that are not mirrored in x, see
    /// LayerProblem::needs_symmetry(); else empty.
    std::vector<Directions> held_if_odd;
    /// Forces along z of a pressure all over the base, one in all, on the free unknowns; empty but
    /// for LayerProblem::pressed_evenly. A node in the middle of the base is held along z there: it
    /// carries its own part of such a pressure, and no more.
    std::vector<double> even_load;
};

}  // namespace tricontact::fem
