#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/compliances/compliance.h"
#include "fem/condensed_layer.h"
#include "fem/pressure_transfer.h"

// Contact of bodies whose nodes do not match. Pressures and tractions live on a grid of their own
// in the plane that both surfaces are seen on, bilinear between its points (a mortar), and a body
// gets the forces that do the same work on its surface:
//
//     f = M p,   M_ik = int phi_i psi_k dA,      gap_k = int psi_k gap dA / int psi_k dA
//
// so that a uniform pressure loads both bodies uniformly, whatever their nodes. Per force, p times
// int psi dA, the compliance is A = sum over both bodies of (M/a)' C (M/a); with the same nodes on
// both and M = diag(a) it is the sum of their compliances (pair_compliance.h). Pressures on points
// no closer than the nodes of the coarser body are stable; on closer ones they oscillate, and
// forces of one body's nodes spread over the other's are off by a tenth and more on any mesh.

namespace tricontact::fem {

/// Sides parallel to the axes [m].
struct Rectangle {
    contact::Vector2 low, high;
};

/// Area of the rectangle that a surface covers, seen along z [m^2]; `surface` with quadrilaterals.
double covered_area(const contact::ContactPoints& surface, const Rectangle& rectangle);

/// The largest rectangle of the proportions of the common bounding box, about its middle (of
/// mirrored bodies from y = 0 on), that all surfaces cover; empty where they share none.
std::optional<Rectangle> shared_rectangle(std::span<const contact::ContactPoints* const> surfaces);

/// Half of the longest edge of the faces over the rectangle [m]: nodes of triquadratic elements are
/// no farther apart.
double node_spacing(const contact::ContactPoints& surface, const Rectangle& rectangle);

/// A grid of points that fills the rectangle, no closer than `spacing` along each side; areas are
/// int psi dA, of a mirrored one those of both halves.
contact::ContactPoints pressure_grid(const Rectangle& rectangle, double spacing, bool mirrored);

/// Throws contact::InputError where the surface does not cover the grid.
PressureTransfer transfer_to(const contact::ContactPoints& surface,
                             const contact::ContactPoints& grid);

/// Means of a field on a surface's nodes by the weights psi: M' field / int psi dA.
std::vector<double> weighted_means(const PressureTransfer& transfer, std::span<const double> field);

/// The body as the points of the grid see it: forces on points, weighted means of displacements.
/// There is no contact mass.
CondensedLayer on_grid(CondensedLayer body, const contact::ContactPoints& grid,
                       const PressureTransfer& transfer);

/// The pressure grid on the nodes of a patch that form a grid themselves. All of its points but
/// those on the edge of the patch have one area, where those of nodes differ by a factor of four.
contact::ContactPoints grid_on_nodes(const contact::ContactPoints& patch);

}  // namespace tricontact::fem
