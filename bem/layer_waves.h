#pragma once

#include <vector>

#include "theory/layer_stack.h"

namespace tricontact::bem {

/// A wave number k [1/m] and its weight [1/m] in integrals over k.
struct Wave {
    double k, weight;
};

/// Quadrature over 0 < k < 24/b, b the thickness of the top layer, where layers differ from the
/// half-space of that layer (their difference falls as exp(-2 k b)): to rounding for that
/// difference times waves of the argument k r, r up to `farthest` [m].
std::vector<Wave> layer_waves(const theory::LayerStack& stack, double farthest);

/// Surface compliance of the half-space of this material at k > 0 [1/m], conventions of
/// layer_compliance.h.
theory::LayerCompliance half_space_at(const contact::Material& material, double k);

}  // namespace tricontact::bem
