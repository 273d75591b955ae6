#include "rolling/rate_friction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/fixed_point.h"
#include "rolling/temperatures.h"

namespace tricontact::rolling {

namespace {

double carried_at_rest(const contact::ContactPoints& grid, const SteadyProblem& problem) {
    return std::inner_product(grid.area.begin(), grid.area.end(), problem.bound.begin(), 0.);
}

}  // namespace

ChangingFriction friction_by_rate(const contact::ContactPoints& grid,
                                  const contact::FrictionRate& rate, double at_rest, double speed) {
    const auto left_of = [&grid, &rate, at_rest, speed](const SteadySolution& solution) {
        const double time = grid.spacing[0] / speed;  // over a cell
        std::vector<double> left(grid.size(), 1.);
        for (int row = 0; row < grid.n_y; ++row) {
            double ahead = 1;
            for (int i = grid.n_x - 1; i >= 0; --i) {
                const std::size_t k = static_cast<std::size_t>(row) * grid.n_x + i;
                const double v = speed * contact::norm(solution.slip.at(k));
                const double kept = rate.memory(time, v);
                left[k] = ahead =
                    kept * ahead + (1 - kept) * rate.coefficient(at_rest, v) / at_rest;
            }
        }
        return left;
    };
    return {left_of, rate.least(at_rest) / at_rest, "falls with the speed of slip",
            "give it a friction.rate.memory_length, or fall less"};
}

ChangingFriction friction_by_temperature(const contact::ContactPoints& grid,
                                         const contact::FrictionTemperature& law,
                                         const contact::ContactHeat& heat, double at_rest,
                                         double speed, const std::vector<double>& bound) {
    contact::Surface s;
    s.n_x = grid.n_x;
    s.n_y = grid.n_y;
    s.spacing = grid.spacing;
    s.normal_traction = bound;
    s.dissipation.assign(grid.size(), 0);
    const auto left_of = [s, &law, &heat, at_rest, speed](const SteadySolution& solution) mutable {
        for (std::size_t i = 0; i < s.size(); ++i)
            s.dissipation[i] =
                std::max(0., contact::dot(solution.traction.at(i), solution.slip.at(i)));
        const std::vector<double> rise = friction_heating(s, heat, speed);
        std::vector<double> left(s.size(), 1.);
        for (std::size_t i = 0; i < left.size(); ++i)
            left[i] = law.coefficient(at_rest, heat.touching_temperature() + rise[i]) / at_rest;
        return left;
    };
    return {left_of, (at_rest + law.change) / at_rest, "changes with the temperature",
            "let it change less"};
}

double solve_steady_rated(const contact::Compliance& compliance, const SteadyProblem& problem,
                          const ChangingFriction& friction, SlipStart from, double tolerance,
                          SteadySolution& solution, std::vector<double>& left) {
    const contact::ContactPoints& grid = compliance.points();
    const auto [least, most] = std::minmax({1., friction.in_the_end});
    if (left.empty()) left.assign(grid.size(), from == SlipStart::slow ? 1 : friction.in_the_end);
    std::vector<double> bound(grid.size());
    contact::OneSidedFixedPoint iteration;
    int iterations = 0;
    for (int k = 0; k < contact::OneSidedFixedPoint::max_iterations; ++k) {
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = left[i] * problem.bound[i];
        try {
            solve_steady(compliance, {bound, problem.displacement, problem.drive, problem.centre},
                         tolerance, solution);
        } catch (const contact::InputError&) {
            if (k == 0) throw;  // at rest, too
            throw contact::InputError(fmt::format(
                "rolling: the force {:.6g} N is more than friction carries that {} ({:.6g} N at "
                "rest); lower it, or prescribe the creepage",
                contact::norm(problem.drive.force), friction.changes,
                carried_at_rest(grid, problem)));
        }
        solution.iterations += iterations;
        iterations = solution.iterations;
        const std::vector<double> next = friction.left(solution);
        double change = 0;
        for (std::size_t i = 0; i < bound.size(); ++i)
            if (bound[i] > 0) change = contact::larger(change, std::abs(next[i] - left[i]));
        if (change <= tolerance) return change;
        left = iteration.next(left, next, change);
        for (double& one : left) one = std::clamp(one, least, most);
    }
    throw contact::NotConverged(fmt::format(
        "steady rolling: after {} iterations friction still follows the slip from one "
        "state to another: it {} too steeply for single cells; {}",
        contact::OneSidedFixedPoint::max_iterations, friction.changes, friction.remedy));
}

}  // namespace tricontact::rolling
