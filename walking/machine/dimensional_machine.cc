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

}  // namespace tricontact::walking
