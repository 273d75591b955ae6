#pragma once

namespace tricontact::theory {

// Carter (1926), Proc. R. Soc. A 112: a cylinder in steady rolling towards +x under a tangential
// force, plane strain, no coupling of normal and tangential contact (Dundurs' beta = 0: bodies of
// one material, or an incompressible one under a rigid one). Hertz' line contact of half width a;
// 1/R is the relative curvature. Dimensionless:
//   f = F_T/(mu F_N) in [0, 1]   force on the substrate along +x, that of a braked indenter,
//   xi R/(mu a) >= 0             creepage, slid over rolled way, of the indenter over the
//   substrate.
// The sign is that of Kalker's slip: friction acts on the substrate along it. Neither modulus nor
// Poisson's ratio enter: without coupling a plane gives way to both tractions alike (1/E*).
// Every function throws std::domain_error out of these ranges.

/// xi R/(mu a) = 1 - sqrt(1 - f). Johnson (1985), Contact Mechanics, eq. 8.48.
double carter_creepage_ratio(double f);

/// Its inverse, f of xi R/(mu a); 1 beyond 1, where all slides.
double carter_force_ratio(double creepage_ratio);

/// Half width c/a = sqrt(1 - f) of the stick zone, which begins at the leading edge: its centre is
/// at x/a = 1 - c/a. Johnson (1985), eq. 8.46.
double carter_stick_ratio(double f);

/// Traction tau/(mu p0) on the substrate at x/a:
/// sqrt(1 - (x/a)^2) - (c/a) sqrt(1 - ((x - a + c)/c)^2), the second term in the stick zone only,
/// zero outside of the contact. Johnson (1985), eq. 8.45.
double carter_traction(double x, double f);

}  // namespace tricontact::theory
