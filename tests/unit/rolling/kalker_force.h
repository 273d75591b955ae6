#pragma once

#include <cmath>

#include "theory/creep_law.h"
#include "theory/rolling/kalker.h"

namespace tricontact::rolling_test {

/// Force of friction on the substrate.
struct CreepForce {
    double longitudinal, lateral, moment;  // F_x, F_y [N], M_z through the centre [N m]
};

/// By Kalker's coefficients, as theory/rolling/kalker.h says.
inline CreepForce kalker_force(const theory::CombinedMaterial& material, double a, double b,
                               const theory::Creepage& creepage) {
    const theory::KalkerCoefficients c = theory::kalker_coefficients(a / b, material.poisson);
    const double size = std::sqrt(a * b), stiffness = material.shear_modulus * a * b;
    return {stiffness * c.longitudinal * creepage.longitudinal,
            stiffness * (c.lateral * creepage.lateral + size * c.spin * creepage.spin),
            stiffness * size * (-c.spin * creepage.lateral + size * c.moment * creepage.spin)};
}

}  // namespace tricontact::rolling_test
