#include "walking/machine/dimensional_machine.h"

#include <cmath>

namespace tricontact::walking {

double characteristic_time(const DimensionalMachine& machine) {
    return std::sqrt(machine.mass / machine.tangential_stiffness);
}

double force_unit(const DimensionalMachine& machine) {
    return machine.tangential_stiffness * machine.half_width;
}

Kappas kappas_of(const DimensionalMachine& machine) {
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

DimensionalMachine with_dimensions(const Kappas& kappas, double mass, double half_width,
                                   double gravity) {
    const auto& [kappa1, kappa2, kappa3, kappa4, mu, kappa6, kappa7, kappa8] = kappas;
    const double k_x = mass * gravity / (kappa4 * half_width);
    const double a = kappa3 * half_width;
    return {.mass = mass,
            .half_height = a,
            .half_width = half_width,
            .moment_of_inertia = kappa7 * mass * half_width * half_width,
            .spring_stiffness = kappa1 * k_x,
            .normal_stiffness = kappa2 * k_x,
            .tangential_stiffness = k_x,
            .friction_coefficient = mu,
            .base_velocity = kappa6 * half_width / std::sqrt(mass / k_x),
            .lever_arm = kappa8 * a,
            .gravity = gravity};
}

}  // namespace tricontact::walking
