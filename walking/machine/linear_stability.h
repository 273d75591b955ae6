#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// Largest angular frequency [sqrt(k_x/m)] of small vibrations with every spot in contact and
/// sticking: no contact state is stiffer. The moments of second order in phi are left out; they
/// are smaller by kappa4.
double highest_frequency(const Machine& machine);

/// Step [sqrt(m/k_x)] above which velocity Verlet blows up: 2/omega of highest_frequency. Hairer,
/// Lubich, Wanner, Geometric Numerical Integration (2006), section I.5.1.
double stable_step(const Machine& machine);

/// Motion at time 0 of a machine whose spots all slip forwards at velocity kappa6, with a spring
/// force that keeps x'' = 0: u = mu kappa2 n at the approaches that `z` and `phi` give; without
/// coupling at those of rest.
Motion sliding_motion(const Machine& machine, double z, double phi);

/// Steady sliding: the sliding motion that stays, z'' = phi'' = 0. None where the body tilts: no
/// |phi| up to tilting_limit balances the moments. For two spots that is friction above
/// critical_friction, in the prism above 1/sqrt(2) of it (normal_load_factor), but for a share of
/// the order of kappa4.
std::optional<Motion> steady_sliding(const Machine& machine);

/// Eigenvalues [sqrt(k_x/m)] of small disturbances of `motion`, a sliding_motion; a disturbance
/// grows as exp(Re t) and turns with Im. Two for each way the body may move; in the prism one more
/// for each spot in contact: the slip turns back into the direction of motion.
std::vector<std::complex<double>> sliding_eigenvalues(const Machine& machine, const Motion& motion);

/// The eigenvalue of the fastest growth, Im >= 0. Re above zero: flutter where Im is not zero,
/// divergence where it is. Without friction to damp them vibrations persist, Re = 0.
std::complex<double> leading_eigenvalue(const Machine& machine, const Motion& motion);

/// Least friction coefficient up to `highest` with which steady sliding flutters; none if it does
/// not, or tilts first. Found in steps of highest/200, then by bisection: ranges of flutter that
/// are narrower may be missed. kappa5 of the machine is not looked at.
std::optional<double> flutter_friction(Machine machine, double highest);

}  // namespace tricontact::walking
