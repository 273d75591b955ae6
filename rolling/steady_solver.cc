#include "rolling/steady_solver.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "contact/base/error.h"
#include "rolling/steady_newton.h"

namespace tricontact::rolling {

namespace {

/// Where all cells slip, in a direction that pressure gives them, the force hardly follows the
/// creepage and Newton's steps lead nowhere: the force along x is bracketed, which grows with the
/// creepage, until Newton's method arrives from there. `unit`: a creepage of its size [-].
void bracket(const contact::Compliance& compliance, const SteadyProblem& problem,
             const SteadyTolerances& tolerances, double unit, SteadySolution& solution) {
    Drive drive = problem.drive;  // creepage along x in place of the force
    const SteadyProblem at_creepage{problem.bound,  problem.displacement, drive,
                                    problem.centre, problem.slip_unit,    problem.stick_inverse};
    const auto missing_force = [&](double creepage) {
        drive.creepage[0] = creepage;
        SteadyNewton(compliance, at_creepage, tolerances, solution).run();
        double missing = problem.drive.force[0];
        for (std::size_t i = 0; i < problem.bound.size(); ++i)
            missing -= compliance.points().area[i] * solution.traction.x[i];
        return missing;
    };
    const auto arrives = [&] {
        SteadySolution guess = solution;
        try {
            SteadyNewton(compliance, problem, tolerances, guess).run(SteadyNewton::careful_steps);
        } catch (const contact::NotConverged&) {
            return false;
        }
        solution = std::move(guess);
        return true;
    };
    double low = -unit, high = unit;
    while (missing_force(low) < 0) low = 2 * low;
    while (missing_force(high) > 0) high = 2 * high;
    while (!arrives()) {
        const double middle = std::midpoint(low, high);
        if (middle <= low || middle >= high)
            throw contact::NotConverged(
                fmt::format("steady rolling: no creepage has the force {:.6g} N: {:.6g} N are "
                            "missing at {:.15g}, beyond it next to there",
                            problem.drive.force[0], missing_force(low), low));
        (missing_force(middle) > 0 ? low : high) = middle;
    }
}

}  // namespace

void solve_steady(const contact::Compliance& compliance, const SteadyProblem& problem,
                  const SteadyTolerances& tolerances, SteadySolution& solution) {
    const SteadySolution start = solution;
    SteadyNewton newton(compliance, problem, tolerances, solution);
    try {
        newton.run();
    } catch (const contact::NotConverged&) {
        if (problem.drive.creepage[0]) throw;
        solution = start;
        bracket(compliance, problem, tolerances, newton.sliding_creepage(), solution);
    }
}

}  // namespace tricontact::rolling
