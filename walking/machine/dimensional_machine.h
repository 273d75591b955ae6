#pragma once

#include <cmath>
#include <optional>

#include "contact/substrates/material.h"
#include "walking/machine/machine.h"

namespace tricontact::walking {

/// What the stiffness of a contact spot follows from: a contact area and the bodies at it. Wetter
/// (2016), eqs. 4.1.7, 4.1.8 and 5.2.3.
struct SpotContact {
    double diameter = 0;  ///< D_c [m]
    contact::Material body = {};
    std::optional<contact::Material> substrate = {};  ///< empty: rigid

    /// k_z = E* D_c [N/m].
    double normal_stiffness() const {
        return contact::MaterialPair(substrate, body).effective_modulus() * diameter;
    }
    /// k_x = G* D_c [N/m].
    double tangential_stiffness() const {
        return contact::MaterialPair(substrate, body).effective_shear_modulus() * diameter;
    }
};

/// A micro-walking machine in SI units. Wetter (2016), section 4.1.1.
struct DimensionalMachine {
    double mass = 0;                  ///< m [kg]
    double half_height = 0;           ///< a [m]
    double half_width = 0;            ///< b [m]
    double moment_of_inertia = 0;     ///< Theta [kg m^2], about the centre of gravity
    double spring_stiffness = 0;      ///< k_s [N/m]
    double normal_stiffness = 0;      ///< k_z [N/m], of a contact spot
    double tangential_stiffness = 0;  ///< k_x [N/m], of a contact spot
    double friction_coefficient = 0;  ///< mu
    double base_velocity = 0;         ///< v_0 [m/s]
    double lever_arm = 0;             ///< h [m], of the spring above the centre of gravity
    double gravity = 9.81;            ///< g [m/s^2]
};

/// sqrt(m/k_x) [s], the unit of time.
inline double characteristic_time(const DimensionalMachine& machine) {
    return std::sqrt(machine.mass / machine.tangential_stiffness);
}

/// k_x b [N], the unit of forces.
inline double force_unit(const DimensionalMachine& machine) {
    return machine.tangential_stiffness * machine.half_width;
}

/// Dimensionless parameters of a machine: Wetter (2016), table 4.1.1.
inline Kappas kappas_of(const DimensionalMachine& machine) {
    const auto& [m, a, b, theta, k_s, k_z, k_x, mu, v_0, h, g] = machine;
    return {.kappa1 = k_s / k_x,
            .kappa2 = k_z / k_x,
            .kappa3 = a / b,
            .kappa4 = m * g / (k_x * b),
            .kappa5 = mu,
            .kappa6 = v_0 / b * characteristic_time(machine),
            .kappa7 = theta / (m * b * b),
            .kappa8 = h / a};
}

}  // namespace tricontact::walking
