#pragma once

#include <vector>

#include "contact/bodies/height_map.h"

namespace tricontact::contact {

/// A synthetic self-affine surface, isotropic and periodic, with random phases: power spectral
/// density C(q) constant from 2 pi/long_wavelength to 2 pi/roll_off, then falling as
/// q^(-2 (1 + hurst)) to 2 pi/short_wavelength, zero outside. Persson et al. (2005), section 3.
struct Roughness {
    double hurst = 0;             ///< H [-]
    double rms_slope = 0;         ///< root mean square of the gradient [-]
    double long_wavelength = 0;   ///< [m], the period
    double roll_off = 0;          ///< wavelength [m]
    double short_wavelength = 0;  ///< [m]
    int seed = 0;                 ///< of the phases
};

/// The surface on n x n nodes of one period, node (0, 0) at its corner, mean height zero. Phases
/// are those of std::mt19937_64 in an order of wave vectors that does not depend on n: finer
/// lattices sample the same surface, on every machine alike but for rounding. The rms slope is that
/// of the surface itself, of a lattice's differences it is less. Throws InputError if the
/// wavelengths are not in order or the lattice does not resolve the shortest: n > 2 L/lambda_s.
HeightMap make_roughness(const Roughness& roughness, int n);

/// Fewest nodes per period that the surface is looked up on without loss: 8 per shortest wave, a
/// number FFTs are fast at.
int fewest_roughness_nodes(const Roughness& roughness);

/// Power spectral density C [m^4] at wave numbers q [1/m], ∫ C d^2q being the mean square of the
/// heights; 0 of waves longer than long_wavelength or shorter than short_wavelength.
std::vector<double> spectral_density(const Roughness& roughness,
                                     const std::vector<double>& wave_numbers);

/// Root mean square of the surface's heights [m].
double rms_height(const Roughness& roughness);

}  // namespace tricontact::contact
