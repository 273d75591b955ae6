#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/case.h"
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
/// A single layer on a rigid plane: its closed form. Else by the waves of layer_stack.h.
/// Absolute accuracy about 1e-14 of the half-space's.
LayerCompliance surface_compliance(const LayerStack& stack, double wave_number);

/// The same of the half-space of this material.
LayerCompliance half_space_compliance_at(const contact::Material& material, double wave_number);

/// Wave number [1/m] at which what lies below the layers begins to be seen: panels of integrals
/// over k grow from here. 1e-4 over the thickness of all layers, less on a ground much softer than
/// the stiffest of them.
double softest_wave_number(const LayerStack& stack);

/// The layers of a case and what they rest on. `model`: asks for them, named in the message. Throws
/// contact::InputError if the case has no substrate.thickness, or no ground for a half-space.
LayerStack layers_of(const std::string& model, const contact::Case& c);

/// Amplitudes of a plane strain wave along s at one depth; z into the body.
struct PlaneStrainWave {
    double u_along = 0, u_z = 0;               ///< displacement [m/Pa]
    double tau = 0, sigma_z = 0;               ///< stress between s and z, and along z [-]
    double sigma_along = 0, sigma_across = 0;  ///< along s, and across it in the surface [-]
};

/// What unit tractions cos(k s) on the surface of layers make at one depth.
struct InteriorWaves {
    PlaneStrainWave pressed;  ///< by pressure: u_along and tau as sin(k s), the others as cos(k s)
    PlaneStrainWave sheared;  ///< along s: u_along and tau as cos(k s), the others as sin(k s)
    double across_u = 0;      ///< across s: displacement as cos(k s) [m/Pa]
    double across_tau = 0;    ///< stress between that direction and z as cos(k s) [-]
    double across_shear = 0;  ///< stress between that direction and s as sin(k s) [-]
};

/// At the wave number k > 0 [1/m], for each of `depths` [m]: increasing, from 0 to the thickness of
/// all layers; on an interface the state above it. Materials and thicknesses must be valid (see
/// check).
///
/// The displacements and tractions that the ground admits are carried upwards, in steps of at most
/// one over k, by the exact propagator of plane strain and antiplane waves, and made orthonormal
/// after each (Godunov 1961): no exponential overflows at any k b. The surface says how much of
/// each there is, and what the steps took out leads back down. Absolute accuracy about 1e-14 of the
/// half-space's; what lies deeper than 50 over k is zero to that.
std::vector<InteriorWaves> interior_waves(const LayerStack& stack, double wave_number,
                                          std::span<const double> depths);

}  // namespace tricontact::theory
