#pragma once

#include "contact/substrates/relaxation.h"

namespace tricontact::theory {

/// Rolling resistance over normal force [-] of a body x^2/(2 R) + f(y) that rolls slowly along x
/// over any substrate whose stiffness K relaxes as one, to the first order in the speed v [m/s]:
///   sum g_i v tau_i/R.
/// Slow relaxation is a viscosity beside the spring, K (u + T du/dt), T = sum g_i tau_i; it
/// dissipates v^2 T ∫ du/dx K du/dx dA = v^2 T ∫ du/dx dp/dx dA = v^2 T ∫ p/R dA, by parts: u'' is
/// -1/R where p is not zero. Of a sphere: Brilliantov and Poeschel (1998), Europhys. Lett. 42, 511.
inline double slow_resistance_ratio(const contact::Relaxation& relaxation, double speed,
                                    double radius) {
    double way = 0;
    for (const auto& [ratio, time] : relaxation.branches) way += ratio * time * speed;
    return way / radius;
}

}  // namespace tricontact::theory
