#pragma once

namespace tricontact::theory {

/// Maugis (1992, J. Colloid Interface Sci. 150, 243): a paraboloid of the radius R on a half-space
/// whose surfaces attract each other by a constant stress sigma_0 up to a gap of w/sigma_0. The
/// contact has the radius a, the ring of tension around it ends at c. With K = 4/3 E*,
///   A = a (K/(pi w R^2))^(1/3),  P = F/(pi w R),  D = d (K^2/(pi^2 w^2 R))^(1/3),  m = c/a,
///   lambda = 2 sigma_0 (R/(pi w K^2))^(1/3).
struct MaugisContact {
    double radius;       ///< A [-]
    double ring;         ///< m = c/a [-]
    double force;        ///< P [-]
    double indentation;  ///< D [-]
};

/// What A, P and D are multiples of: a [m], F [N], d [m].
struct MaugisUnits {
    double radius, force, indentation;
};
MaugisUnits maugis_units(double radius, double work, double modulus);

/// Of the radius A > 0 at lambda > 0, his eq. 6.16 to 6.18. Throws std::domain_error.
MaugisContact maugis_contact(double lambda, double radius);

/// lambda [-]. Throws std::domain_error unless all are positive.
double maugis_parameter(double radius, double work, double modulus, double peak_stress);

/// The state of the largest tension, in [3/2, 2] pi w R.
MaugisContact maugis_pull_off(double lambda);

/// On the branch that is stable under force, A >= that of pull-off, under P. Throws
/// std::domain_error where it pulls off.
MaugisContact maugis_contact_under(double lambda, double force);
/// On the same branch at D >= that of pull-off; likewise.
MaugisContact maugis_contact_at(double lambda, double indentation);

}  // namespace tricontact::theory
