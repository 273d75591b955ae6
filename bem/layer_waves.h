#pragma once

#include <vector>

#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// A wave number k [1/m] and its weight [1/m] in integrals over k.
struct Wave {
    double k, weight;
};

/// Where the surfaces of layers and of the half-space of the top layer, b thick, no longer differ:
/// exp(-2 k b) (k b)^2 < 1e-18.
inline constexpr double last_surface_wave = 24;  // k b

/// The same inside: exp(-k b) (k b)^3 < 1e-16 at the bottom of the layer.
inline constexpr double last_inside_wave = 48;  // k b

/// Quadrature over 0 < k < `last`/b, where layers differ from that half-space: to rounding for the
/// difference times waves of the argument k r, r up to `farthest` [m].
std::vector<Wave> layer_waves(const theory::LayerStack& stack, double farthest,
                              double last = last_surface_wave);

/// Surface compliance of the half-space of this material at k > 0 [1/m], conventions of
/// layer_compliance.h.
theory::LayerCompliance half_space_at(const contact::Material& material, double k);

/// The half-space that the top layer would be part of, cut where the layers are.
theory::LayerStack continued(const theory::LayerStack& stack);

}  // namespace tricontact::bem
