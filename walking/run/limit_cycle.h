#pragma once

#include <optional>
#include <span>

#include "walking/machine/machine.h"
#include "walking/run/walk.h"

namespace tricontact::walking {

/// A motion that repeats itself, over whole periods.
struct LimitCycle {
    int section_points = 0;         ///< returns to the Poincare section in a period
    int n_periods = 0;              ///< observed
    double begin = 0;               ///< time of the first one
    double period = 0;              ///< their mean, in units of sqrt(m/k_x)
    double spring_force = 0;        ///< mean f_s
    double period_drift = 0;        ///< how much the means of both halves of the time differ:
    double spring_force_drift = 0;  ///< what is left of the way to the cycle, or less than a step
    StretchSums sums;               ///< over all periods
    bool slides = false;            ///< spots farther in a period than returns miss each other
    bool settled = false;  ///< no longer on the way to it, or at half the pace in half the time
};

/// Distance of two returns in the energy of their difference: square root of the kinetic energy of
/// the difference of the velocities and the elastic energy of that of the displacements, on springs
/// of stiffness k_x. In units of sqrt(k_x b^2/2).
double distance(const Machine& machine, const Motion& a, const Motion& b);

/// Means over as many periods of `points` returns as there are, counted from the end. At least
/// two periods and a return.
LimitCycle mean_cycle(const Machine& machine, std::span<const SectionReturn> returns, int points,
                      double step);

/// The limit cycle on which a run ends, if there is one: every return of its end is as near to the
/// one a period earlier as the integration of this step can tell. `returns` are consecutive.
std::optional<LimitCycle> find_limit_cycle(const Machine& machine,
                                           std::span<const SectionReturn> returns, double step);

}  // namespace tricontact::walking
