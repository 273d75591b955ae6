#pragma once

namespace tricontact::theory {

// Heat sources that move over a half-space at the speed V, q [W/m^2] on -a < x < a, x downstream:
// towards where the material flows. Fast ones (Pe = V a/(2 kappa) >> 1) heat it by flow into the
// depth alone, dT = 1/(b (pi V)^(1/2)) int q(s) (x - s)^(-1/2) ds (Carslaw and Jaeger 1959,
// sections 2.9 and 10.7), b its effusivity. As multiples of q/b (a/(pi V))^(1/2), x over a:

/// Of a uniform q (Blok 1937; Jaeger 1942); 0 at x <= -1.
double uniform_heating(double x);
/// Of q (1 - x^2)^(1/2), as of Hertz' pressure, -1 <= x <= 1: with m = (1 + x)/2
/// 4 2^(1/2)/3 [(2 m - 1) E(m) + (1 - m) K(m)]. Throws std::domain_error elsewhere.
double elliptic_heating(double x);

/// How much flow into the depth alone overestimates the highest temperature under a uniform band
/// [-], beside its exact one at this Pe > 0 (plane flow; Jaeger 1942, eq. 21). Throws
/// std::domain_error.
double band_error(double peclet);

}  // namespace tricontact::theory
