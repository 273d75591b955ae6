#pragma once

#include <array>

namespace tricontact::theory {

/// A published series for a rigid paraboloid pressed without friction on an incompressible
/// (nu = 1/2) layer bonded to a rigid base: F over Hertz' force at the same indentation d,
///   1 + c1 chi + c2 chi^2 + c3 chi^3 + c4 chi^4,  chi = sqrt(R d)/b.
/// For comparison only: the exact curve is that of solve_layer_contact (elastic_layer.h), with
/// c1 = 1.12695, c2 = 7/6 c1^2 = 1.4817, c3 = 1.470. Errors of the force against it, in percent:
///   chi                      .1     .2     .5     1      2
///   Dimitriadis et al.      -0.19  -1.06  -7.73  -16.3  -12.3
///   Garcia and Garcia        0.06   0.12   0.71   14.4   80.1
struct LayerForceSeries {
    const char* source;
    std::array<double, 4> coefficients;  ///< c1 to c4

    /// F/F_Hertz at chi >= 0. Throws contact::InputError for other chi.
    double force_ratio(double chi) const;
};

/// Dimitriadis, Horkay, Maresca, Kachar and Chadwick (2002), Biophys. J. 82. Too soft: c2 is c1^2
/// there, as if the layer did not change the contact radius.
inline constexpr LayerForceSeries dimitriadis_series{"Dimitriadis et al. (2002)",
                                                     {1.133, 1.283, 0.769, 0.0975}};
/// Garcia and Garcia (2018), Biophys. J. 114: right to third order.
inline constexpr LayerForceSeries garcia_series{"Garcia and Garcia (2018)",
                                                {1.133, 1.497, 1.469, 0.755}};

}  // namespace tricontact::theory
