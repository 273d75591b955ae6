#pragma once

#include <optional>
#include <vector>

#include "contact/substrates/material.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::theory {

/// Elastic layers of infinite width, bonded to each other, on the ground: a rigid plane or an
/// elastic half-space (to which the lowest layer is bonded).
struct LayerStack {
    struct Sheet {
        contact::Material material{0, 0};
        double thickness = 0;  ///< [m]
    };
    std::vector<Sheet> sheets;  ///< from the top, at least one
    LayerBase base = LayerBase::bonded;
    std::optional<contact::Material> half_space;  ///< below, instead of a rigid plane

    double thickness() const;  ///< of all sheets [m]
};

/// Throws contact::InputError unless there is a layer, every material is valid and every thickness
/// positive and finite.
void check(const LayerStack& stack);

/// Surface compliance at the wave number k > 0 [1/m], conventions of layer_compliance.h; k = 0
/// where that is finite for a single layer on a rigid plane. Throws contact::InputError.
///
/// A single layer on a rigid plane: its closed form. Else by the waves of interior_waves.h.
/// Absolute accuracy about 1e-14 of the half-space's.
LayerCompliance surface_compliance(const LayerStack& stack, double wave_number);

/// Wave number [1/m] at which what lies below the layers begins to be seen: panels of integrals
/// over k grow from here. 1e-4 over the thickness of all layers, less on a ground much softer than
/// the stiffest of them.
double softest_wave_number(const LayerStack& stack);

}  // namespace tricontact::theory
