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
// wrong: the stick zone is no ellipse, see docs/rolling.md for the error of each. Signs as in
// carter.h.

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

}  // namespace tricontact::theory
