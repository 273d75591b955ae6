#pragma once

#include "theory/layer/elastic_layer.h"
#include "theory/layer/line_contact.h"

namespace tricontact::theory {

// What the free sides of a bonded block add to the indentation of a rigid body under the same
// force, against the unbounded layer that LayerContact and LineContact are about.
//
// Away from the contact the disturbance of a strip, free above and bonded below, decays as
// exp(-lambda r/b), lambda the smallest root of
//   kappa cos^2 lambda = lambda^2 - (kappa - 1)^2/4,  kappa = 3 - 4 nu
// (Williams 1952, J. Appl. Mech. 19, 526, clamped and free side; the wedge's angle going to zero).
// It is real: 0.739 at nu = 1/2, 0.913 at 0.3. A side at the distance rho from the centre of the
// contact is felt after the way there and back. Of a point load on the axis of a disc of this
// radius, F/(G b) phi(rho/b) is added to the displacement,
//   phi(t) = exp(-2 lambda t) sqrt([1/(2 pi (1 + nu) t^2)]^2 + A^2),
// which of thick blocks is the compression of a column, b F/(E pi rho^2), as t -> 0; A, what is
// left of the decay for t -> infinity, goes with the square of a mode's amplitude that changes its
// sign with nu. A line between two sides has (1 - nu)/(4 t (1 + 2 t)) and another A instead, the
// force per length and G without b. A contact that is not small feels the mode's mean over Hertz'
// pressure, twice: I0 over the disc, cosh over the strip, of lambda a/b. Each direction has its
// share of a block that is no disc, as if the side ran around the contact at the distance that it
// has there: exact for straight sides that are far, by the method of stationary phase.
//
// A was fitted to axisymmetric and plane finite elements, nu = 0 to 1/2, b/a = 1/4 to 40;
// the margins cover what these had more than the form has, from sides a/2 off the contact's edge
// on, and of a strip what a contact off its middle adds by bending. Against tricontact's own:
// tests/verification/fem/free_sides.cc.

/// lambda, the least decay of a layer's disturbances over r/b, nu in (-1, 1/2].
double edge_decay(double poisson);

/// phi of a point load on a disc of the radius t b; of a line load between sides at t b.
double disc_side_compliance(double poisson, double t);
double strip_side_compliance(double poisson, double t);

inline constexpr double block_margin = 1.15, strip_margin = 1.25;
/// Where the estimate exceeds 5 % it is at most so many times the effect, ...
inline constexpr double largest_side_excess = 2;
/// ... from this Poisson's ratio on.
inline constexpr double least_side_poisson = 0.1;
/// Distance of a side from the contact's edge over a from which on the margin covers the fit.
inline constexpr double nearest_side = 0.5;

/// Distances of a block's four sides from the centre of the contact [m], > 0.
struct BlockSides {
    double right, left;  ///< along x
    double front, back;  ///< along y
};

/// An upper estimate of what free sides add to the indentation, over it.
double side_effect(const ElasticLayer& layer, const LayerContact& contact, const BlockSides& sides);
/// The same under a cylinder, of the sides along x.
double side_effect(const ElasticLayer& layer, const LineContact& contact, double right,
                   double left);

}  // namespace tricontact::theory
