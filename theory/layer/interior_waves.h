#pragma once

#include <span>
#include <vector>

#include "theory/layer/layer_stack.h"

namespace tricontact::theory {

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
