#pragma once

#include "walking/machine/machine.h"

namespace tricontact::walking {

/// Largest angular frequency [sqrt(k_x/m)] of small vibrations with every spot in contact and
/// sticking: no contact state is stiffer. The moments of second order in phi are left out; they
/// are smaller by kappa4.
double highest_frequency(const Machine& machine);

/// Step [sqrt(m/k_x)] above which velocity Verlet blows up: 2/omega of highest_frequency. Hairer,
/// Lubich, Wanner, Geometric Numerical Integration (2006), section I.5.1.
double stable_step(const Machine& machine);

}  // namespace tricontact::walking
