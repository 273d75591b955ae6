#pragma once

namespace tricontact::dynamics {

/// Dimensionless parameters of a micro-walking machine: a body of mass m, half height a, half width
/// b and moment of inertia Theta on contact spots of stiffness k_x and k_z, dragged by a spring k_s
/// at height h above its centre of gravity, whose base moves at v_0. Lengths are in units of b,
/// times of sqrt(m/k_x). Wetter (2016), table 4.1.1.
struct Kappas {
    double kappa1 = 0;  ///< k_s/k_x
    double kappa2 = 0;  ///< k_z/k_x
    double kappa3 = 0;  ///< a/b
    double kappa4 = 0;  ///< m g/(k_x b)
    double kappa5 = 0;  ///< friction coefficient mu
    double kappa6 = 0;  ///< (v_0/b) sqrt(m/k_x)
    double kappa7 = 0;  ///< Theta/(m b^2)
    double kappa8 = 0;  ///< h/a

    bool operator==(const Kappas&) const = default;
};

/// Friction above which the sliding body tilts over its leading spot; infinite where the spring
/// pulls at or below the base. Wetter (2016), eq. 4.2.13.
double critical_friction(const Kappas& kappas);

}  // namespace tricontact::dynamics
