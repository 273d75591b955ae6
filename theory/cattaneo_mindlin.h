#pragma once

namespace tricontact::theory {

// Cattaneo (1938) and Mindlin (1949): a Hertzian contact under constant normal force F_N, then a
// tangential force F_T = f mu F_N. Dimensionless unless said otherwise: f = F_T/(mu F_N), radii
// over the contact radius a, traction over mu p0, shift over U_max = mu (E*/G*) d.
// Exact for Poisson's ratio 0; otherwise a transverse traction of the order of nu/(4 - 2 nu) of
// the slip traction is neglected (Johnson 1985, section 7.2d).
// Range 0 <= f <= 1; every function throws std::domain_error outside of it.

/// Radius c/a of the stick zone: (1 - f)^(1/3). Johnson (1985), eq. 7.40.
double stick_radius_ratio(double f);

/// Traction tau/(mu p0) in the direction of F_T at the radius rho = r/a >= 0:
/// sqrt(1 - rho^2) - (c/a) sqrt(1 - rho^2 a^2/c^2), the second term inside the stick zone only,
/// zero outside the contact. Johnson (1985), section 7.2d.
double cattaneo_mindlin_traction(double rho, double f);

/// Rigid shift U/U_max under F_T applied once: 1 - (1 - f)^(2/3). Johnson (1985), eq. 7.42b.
double static_shift_ratio(double f);

/// A tangential force that oscillates between -f mu F_N and +f mu F_N, F_N constant.
struct OscillatingForce {
    double friction_coefficient;     ///< mu [-], > 0
    double normal_force;             ///< F_N [N], > 0
    double effective_shear_modulus;  ///< G* [Pa], > 0
    double contact_radius;           ///< a [m], > 0
    double tangential_ratio;         ///< f [-], in [0, 1]
};

/// Work [J] dissipated in one cycle of `load`:
/// W0 = 18/5 mu^2 F_N^2/(G* a) { 1 - (1-f)^(5/3) - 5/6 f [1 + (1-f)^(2/3)] }.
/// Mindlin and Deresiewicz (1953); Johnson (1985), eq. 7.57, with G* of both bodies.
double cycle_dissipation(const OscillatingForce& load);

}  // namespace tricontact::theory
