#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/friction/friction_rate.h"
#include "contact/heat.h"
#include "rolling/steady_newton.h"

namespace tricontact::rolling {

/// Friction that follows from the steady state itself.
struct ChangingFriction {
    /// mu over mu at rest of each point [-] in this state, row by row.
    std::function<std::vector<double>(const SteadySolution&)> left;
    double in_the_end = 0;  ///< the same where slip, or heat, has no bounds [-]
    std::string changes;    ///< "falls with the speed of slip"
    std::string remedy;     ///< where that is too steep: "let it fall less"
    /// How `left` changes with the slip, for Newton's method; empty: unknown.
    std::function<BoundSlopes(const SteadySolution&)> slopes = {};
    double steepest = 0;    ///< of them, by size; 0: unknown
    double slip_alone = 0;  ///< see below; 0: points follow together alone
};

/// Slip over traction of a point by itself [1/Pa]: what its own traction slides it by.
double slip_alone(const contact::Compliance& compliance);

/// mu by the speed of slip: from the leading edge, where it is 1. `speed`: of rolling [m/s];
/// `at_rest`: mu [-]. What it refers to shall outlive it.
ChangingFriction friction_by_rate(const contact::ContactPoints& grid,
                                  const contact::FrictionRate& rate, double at_rest, double speed);

/// mu by the temperatures of the surfaces where they touch, see temperatures.h; `bound` [Pa]: above
/// 0 in contact. Likewise.
ChangingFriction friction_by_temperature(const contact::ContactPoints& grid,
                                         const contact::FrictionTemperature& law,
                                         const contact::ContactHeat& heat, double at_rest,
                                         double speed, const std::vector<double>& bound);

/// solve_steady under bounds that follow from the slip: a fixed point of mu, each step of which is
/// the steady state under given bounds. `problem.bound` is that at rest [Pa]. `left`: mu over mu at
/// rest per point, the start and the result; empty: that of `from`.
///
/// Each iterate is solved as exactly as its change deserves; once changes shrink and slopes are
/// known, Newton's method ends the search if it does so near by on their side.
///
/// By the speed of slip mu falls, from slow slip, from one iterate to the next and slip grows, from
/// fast slip the other way round: what they come to are the states of least and of most slip. By
/// the temperature both are ends to begin at. `other`: a state that another search found; where
/// this one comes to it, Newton's method begins there; null: none. Returns the largest change of mu
/// over mu at rest that was left. Throws as solve_steady; InputError when a force is more than what
/// slips carries.
double solve_steady_rated(const contact::Compliance& compliance, const SteadyProblem& problem,
                          const ChangingFriction& friction, SlipStart from, double tolerance,
                          SteadySolution& solution, std::vector<double>& left,
                          const SteadySolution* other = nullptr);

}  // namespace tricontact::rolling
