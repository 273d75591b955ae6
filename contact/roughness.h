#pragma once

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

}  // namespace tricontact::contact
