#pragma once

namespace tricontact::theory {

/// Rigid sliding of the indenter over the substrate per rolled way, rolling towards +x; friction
/// acts on the substrate along it.
struct Creepage {
    double longitudinal = 0;  ///< xi [-], along the rolling direction x
    double lateral = 0;       ///< eta [-], along y
    double spin = 0;          ///< phi [1/m], from x towards y
};

// Creep of a body in steady rolling under a force along its way, from small creepages to sliding,
// by a law of one stiffness: F = mu F_N [1 - (1 - xi/xi_s)^3], xi_s = 3 mu F_N/(G a b C), the
// creepage at which all begins to slide. What theories differ in is the coefficient C, Kalker's C11
// by name. Vermeulen and Johnson (1964), J. Appl. Mech. 31, took an elliptic stick zone that
// touches the leading edge; Shen, Hedrick and Elkins (1983) its law with Kalker's C11. Where it is
// wrong: the stick zone is no ellipse, see docs/explanation/rolling.md for the error of each. Signs
// as in creep_law.h.

/// f = F_T/(mu F_N) at x = xi/xi_s >= 0: 1 - (1 - x)^3, 1 beyond x = 1.
/// Throws std::domain_error for a negative argument.
double cubic_force_ratio(double creepage_ratio);

/// xi/xi_s at f in [0, 1]: 1 - (1 - f)^(1/3). Throws std::domain_error out of range.
double cubic_creepage_ratio(double f);

/// C = 16/(4 - 3 nu) of the elliptic stick zone in a circular contact; of a sphere
/// xi_s = (4 - 3 nu)/(4 (1 - nu)) mu a/R, Wetter's thesis (TU Berlin 2016), eq. 2.1.21.
double vermeulen_johnson_coefficient(double poisson);

/// C = 4/(2 - nu) of the springs of MDR rolled on: G a^2 C = 2 G* a^2; of a sphere
/// xi_s = 2 (E*/G*) mu a/R, which follows from eq. 2.2.24 of the thesis (its 2.2.28 has lost a
/// factor of four). Over the one above: 4 (2 - nu)/(4 - 3 nu), eq. 2.2.31.
double mdr_coefficient(double poisson);

/// Creepage xi_s [-] of the beginning of sliding: 3 `friction_limit`/(G a b C), the friction limit
/// mu F_N in N, G in Pa, a b in m^2.
double sliding_creepage(double friction_limit, double shear_modulus, double area,
                        double coefficient);

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

// The same under a shear strength tau_0 of the interface in the place of mu p. The traction of the
// stick zone [b, a] is bounded at both of its ends and strains the surface alike: a singular
// integral equation with the traction tau_0 behind it (Muskhelishvili 1953). Its expansion at
// infinity tells creepage and force:
//   xi = 4 tau_0/(pi E*) artanh f,  f = F_T/(2 a tau_0 L),  b/a = 2 f^2 - 1.
// For small f it is Carter's line, F_T = pi/2 E* a L xi, whatever the law. The stick zone vanishes
// no sooner than xi is infinite: what comes in free of traction must be strained to tau_0 first.

/// pi E* xi/(4 tau_0) of f in [0, 1); its inverse, of any argument >= 0. std::domain_error else.
double strength_creepage_ratio(double f);
double strength_force_ratio(double creepage_ratio);
/// Half width c/a = 1 - f^2 of the stick zone, which begins at the leading edge.
double strength_stick_ratio(double f);
/// Traction tau/tau_0 at x/a: 2/pi arctan(f sqrt((a - x)/(x - b))) in the stick zone, 1 behind it,
/// zero outside of the contact.
double strength_traction(double x, double f);

/// The springs of MDR under a body of revolution, whose bounds are 2 tau_0 sqrt(a^2 - x^2): each
/// comes in at the leading edge and takes up xi (a - x) until it slides at x = a (eta^2 - 1)/(eta^2
/// + 1), eta = G* xi/(2 tau_0):
///   F_T/(pi a^2 tau_0) = 2/pi [arctan eta + eta/(1 + eta^2)].
double strength_bed_force_ratio(double eta);
/// eta of f in [0, 1).
double strength_bed_creepage_ratio(double f);

// Dissimilar cylinders roll freely, F_T = 0: the normal load alone stretches both surfaces unlike,
// and they creep. Bentall and Johnson (1967), Int. J. Mech. Sci. 9, 389. Creepages over a/R, a
// being Hertz' half width without friction; beta is Dundurs' constant, the substrate's compliance
// counted positive (contact::MaterialPair). Signs as in creep_law.h. What friction there is decides
// between both values. |beta| is at most 1/2 for nu >= 0, and below 3/4 for all nu > -1; beyond,
// they throw std::domain_error.

/// All sticks, mu far above |beta|: 2 e/sqrt(1 + 4 e^2), e = ln((1 + beta)/(1 - beta))/(2 pi).
/// p + i q is a multiple of (a - x)^(1/2 + i e) (a + x)^(1/2 - i e), the solution of the coupled
/// singular integral equations that is bounded at both edges (Muskhelishvili 1953); its expansion
/// at infinity, z - 2 i e a - (1/2 + 2 e^2) a^2/z, tells creepage and force.
double rough_free_creepage(double beta);

/// All slips, mu far below |beta|: .9148 beta. Hertz' pressure alone strains the surface, by
/// 2 beta p/E*; it slips to one side in the strip that carries half of the load, to the other one
/// beside it.
double smooth_free_creepage(double beta);

}  // namespace tricontact::theory
