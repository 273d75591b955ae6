#pragma once

#include "contact/substrates/material.h"

namespace tricontact::theory {

/// From here on exp(-2x) x^2 is below 1e-31: the half-space to the last digit.
inline constexpr double half_space_from = 40;

/// What holds the layer from below: a rigid plane, sticking to the layer or letting it glide.
enum class LayerBase { bonded, frictionless };

/// An elastic layer of infinite width on a rigid plane.
struct ElasticLayer {
    contact::Material material;
    double thickness = 0;  ///< b [m]
    LayerBase base = LayerBase::bonded;
};

/// Throws contact::InputError unless E > 0, -1 < nu <= 1/2 and b > 0, all finite.
void check(const ElasticLayer& layer);

// Surface compliance in Fourier space, per wave vector of length k; surface values are the real
// parts of (...) exp(i k s), s along the wave vector, z into the body, pressure p > 0 pressing,
// tangential traction t acting on the layer:
//   u_z = C33 p - i C13 t_along,  u_along = C11 t_along + i C13 p,  u_across = C22 t_across.
// With x = k b, kappa = 3 - 4 nu:
//   bonded:       D = 2 kappa cosh 2x + 4 x^2 + 1 + kappa^2,
//                 C33, C11 = (1-nu)/(G k) (2 kappa sinh 2x -+ 4 x)/D,  C22 = tanh x/(G k),
//                 C13 = [kappa (kappa - 1) (cosh 2x - 1) - 4 x^2]/(2 G k D);
//   frictionless: D = sinh 2x + 2x,
//                 C33, C11 = (1-nu)/(G k) (cosh 2x -+ 1)/D,  C22 = coth x/(G k),
//                 C13 = [(1 - 2 nu) sinh 2x - 2x]/(2 G k D).
// For x -> infinity the half-space: (1-nu)/(G k) twice, 1/(G k), (1 - 2 nu)/(2 G k).
// Sneddon (1951), Fourier Transforms, ch. 9 and 10, gives the method.

/// Displacement per traction [m/Pa].
struct LayerCompliance {
    double normal;    ///< C33
    double along;     ///< C11
    double across;    ///< C22
    double coupling;  ///< C13
};

/// Compliance of the layer at the wave number k >= 0 [1/m], to a few units of rounding at every
/// k b and nu. At k = 0 the limit: C33 = b (1 - 2 nu)/(2 G (1 - nu)), C11 = C22 = b/G, C13 = 0 if
/// bonded; C33 = b (1 - nu)/(2 G), C11 and C22 infinite, C13 infinite with the sign of -nu if
/// frictionless: nothing holds that layer back. Throws contact::InputError.
LayerCompliance layer_compliance(const ElasticLayer& layer, double wave_number);

/// C13/C11 of a bonded layer at x = k b > 0.
double bonded_coupling_ratio(double poisson, double x);

/// What the layer's compliance lacks against that of the half-space, relative to it:
/// 1 - C/C_half-space, without cancellation, falling as exp(-2x).
struct HalfSpaceDeficit {
    double normal;  ///< of C33, in (0, 1]
    double along;   ///< of C11; negative if softer than the half-space
    double across;  ///< of C22; negative if softer
};

/// Deficit at x = k b >= 0. At x = 0 on a frictionless base `along` and `across` are -infinity.
/// Throws contact::InputError.
HalfSpaceDeficit half_space_deficit(double poisson, LayerBase base, double x);

}  // namespace tricontact::theory
