#pragma once

#include <vector>

#include "statistics/initial_sequence.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// What two nearby runs are compared for; times in units of sqrt(m/k_x).
struct Separation {
    double step = 1e-3;      ///< of velocity Verlet
    double interval = 5;     ///< after which the distance is brought back to what it was
    double alignment = 50;   ///< until the disturbance points in the direction of fastest growth
    double duration = 1000;  ///< after that; two intervals at least
    /// Distance over the static displacement: larger than the rounding of x after a million steps,
    /// smaller than what a spot moves in a step.
    double distance = 1e-6;
};

/// Rates [sqrt(k_x/m)] at which two nearby runs come apart, one per interval: the growth of the
/// logarithm of their distance in displacements, velocities and deflections of sticking springs.
/// Benettin, Galgani, Giorgilli, Strelcyn (1980), Meccanica 15.
std::vector<double> separation_rates(const Machine& machine, const Motion& start,
                                     const Separation& separation = {});

/// Largest Lyapunov exponent [sqrt(k_x/m)] with its 95 % interval: the mean of the rates. Above
/// zero: chaos, or a transient of it. Zero: a limit cycle, whose phase is free, or vibrations that
/// neither grow nor decay.
statistics::Mean lyapunov_exponent(const Machine& machine, const Motion& start,
                                   const Separation& separation = {});

}  // namespace tricontact::walking
