#pragma once

#include <cmath>
#include <string>

#include "walking/kernels/kernel.h"
#include "walking/machine/dimensional_machine.h"
#include "walking/machine/machine.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// Wetter (2016), eq. 4.1.25: slides as if it were one block.
inline Kappas set_a() {
    return {2, 1.2, 0.5, 1e-4, 0.5, 1e-4, 0.42, 0.5};
}

/// Wetter (2016), eq. 4.1.26: walks.
inline Kappas set_b() {
    return {2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};
}

inline std::string name_of(Kernel kernel) {
    constexpr const char* names[] = {"plain", "sse2", "avx2", "avx512"};
    return names[static_cast<int>(kernel)];
}

/// From rest to `end`, in steps of 1e-3.
inline WalkCase case_of(const Kappas& kappas, double end) {
    WalkCase walk_case;
    walk_case.machine.kappas = kappas;
    walk_case.time.end = end;
    return walk_case;
}

/// The machine of these parameters that has this mass [kg], half width [m] and gravity [m/s^2]:
/// kappas_of the other way round.
inline DimensionalMachine with_dimensions(const Kappas& kappas, double mass, double half_width,
                                          double gravity = 9.81) {
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
