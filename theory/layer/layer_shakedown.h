#pragma once

#include "theory/layer/elastic_layer.h"

namespace tricontact::theory {

// Limit of shakedown of a contact that rolls to and fro by the amplitude W, at any angle to the
// load, without coupling of normal and tangential contact: the largest F_T/(mu F_N) that points can
// carry whose traction never exceeds their least bound, (1/F_N) ∫ min over the path of mu p dA over
// mu. If p falls with r, the least pressure is that where the path is farthest from the axis, and
//   f_T,lim = 1 - ∫_0^W q dx / ∫_0^a q dx,   q = ∫ p dy the line load:
// of Hertz' contact 1 - 3/2 w + 1/2 w^3, w = W/a. Pressures under paraboloid and sphere fall with r
// on any layer.

/// f_T,lim at w = W/a in [0, 1]. Throws std::domain_error for other w.
double shakedown_limit(const LayerContact& contact, double w);

/// Its inverse: the largest w that shakes down at f = F_T/(mu F_N) in [0, 1]. Throws
/// std::domain_error for other f.
double amplitude_limit(const LayerContact& contact, double f);

}  // namespace tricontact::theory
