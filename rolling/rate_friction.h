#pragma once

#include <vector>

#include "contact/friction/friction_rate.h"
#include "rolling/steady_solver.h"

namespace tricontact::rolling {

/// Friction that depends on the speed of slip, in a steady state.
struct RatedFriction {
    const contact::FrictionRate& rate;
    double at_rest;  ///< mu [-]
    double speed;    ///< of rolling [m/s]
};

/// mu over mu at rest of each point of a grid [-] at this slip [-], row by row from the leading
/// edge, where it is 1.
std::vector<double> friction_left(const contact::ContactPoints& grid, const RatedFriction& friction,
                                  const contact::TangentialField& slip);

/// solve_steady under bounds that follow from the slip: a fixed point of mu, each step of which is
/// the steady state under given bounds. `problem.bound` is that at rest [Pa]. `left`: mu over mu at
/// rest per point, the start and the result; empty: that of `from`.
///
/// From slow slip mu falls from one iterate to the next and slip grows, from fast slip the other
/// way round: what they come to are the states of least and of most slip. Returns the largest
/// change of mu over mu at rest that was left. Throws as solve_steady; InputError when a force is
/// more than what slips carries.
double solve_steady_rated(const contact::Compliance& compliance, const SteadyProblem& problem,
                          const RatedFriction& friction, SlipStart from, double tolerance,
                          SteadySolution& solution, std::vector<double>& left);

}  // namespace tricontact::rolling
