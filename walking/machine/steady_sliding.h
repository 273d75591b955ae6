#pragma once

#include <optional>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// Motion at time 0 of a machine whose spots all slip forwards at velocity kappa6, with a spring
/// force that keeps x'' = 0: u = mu kappa2 n at the approaches that `z` and `phi` give; without
/// coupling at those of rest.
Motion sliding_motion(const Machine& machine, double z, double phi);

/// Steady sliding: the sliding motion that stays, z'' = phi'' = 0. None where the body tilts: no
/// |phi| up to tilting_limit balances the moments. For two spots that is friction above
/// critical_friction, in the prism above 1/sqrt(2) of it (normal_load_factor), but for a share of
/// the order of kappa4.
std::optional<Motion> steady_sliding(const Machine& machine);

}  // namespace tricontact::walking
