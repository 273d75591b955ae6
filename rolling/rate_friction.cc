#include "rolling/rate_friction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/fixed_point.h"

namespace tricontact::rolling {

namespace {

// One after the other they stay on their side of the state, so that which one is found is known;
// then what they tell of each other is combined.
constexpr int plain_iterations = 30;
constexpr int most_iterations = 500;

double carried_at_rest(const contact::ContactPoints& grid, const SteadyProblem& problem) {
    return std::inner_product(grid.area.begin(), grid.area.end(), problem.bound.begin(), 0.);
}

}  // namespace

std::vector<double> friction_left(const contact::ContactPoints& grid, const RatedFriction& friction,
                                  const contact::TangentialField& slip) {
    const contact::FrictionRate& rate = friction.rate;
    const double time = grid.spacing[0] / friction.speed;  // over a cell
    std::vector<double> left(grid.size(), 1.);
    for (int row = 0; row < grid.n_y; ++row) {
        double ahead = 1;
        for (int i = grid.n_x - 1; i >= 0; --i) {
            const std::size_t k = static_cast<std::size_t>(row) * grid.n_x + i;
            const double speed = friction.speed * contact::norm(slip.at(k));
            const double kept = rate.memory(time, speed);
            left[k] = ahead = kept * ahead + (1 - kept) *
                                                 rate.coefficient(friction.at_rest, speed) /
                                                 friction.at_rest;
        }
    }
    return left;
}

double solve_steady_rated(const contact::Compliance& compliance, const SteadyProblem& problem,
                          const RatedFriction& friction, SlipStart from, double tolerance,
                          SteadySolution& solution, std::vector<double>& left) {
    const contact::ContactPoints& grid = compliance.points();
    const double least = friction.rate.least(friction.at_rest) / friction.at_rest;
    if (left.empty()) left.assign(grid.size(), from == SlipStart::slow ? 1 : least);
    std::vector<double> bound(grid.size());
    contact::FixedPoint accelerated;
    int iterations = 0;
    for (int k = 0; k < most_iterations; ++k) {
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = left[i] * problem.bound[i];
        try {
            solve_steady(compliance, {bound, problem.displacement, problem.drive, problem.centre},
                         tolerance, solution);
        } catch (const contact::InputError&) {
            if (k == 0) throw;  // at rest, too
            throw contact::InputError(fmt::format(
                "rolling: the force {:.6g} N is more than friction carries that falls with the "
                "speed of slip ({:.6g} N at rest); lower it, or prescribe the creepage",
                contact::norm(problem.drive.force), carried_at_rest(grid, problem)));
        }
        solution.iterations += iterations;
        iterations = solution.iterations;
        const std::vector<double> next = friction_left(grid, friction, solution.slip);
        double change = 0;
        for (std::size_t i = 0; i < bound.size(); ++i)
            if (bound[i] > 0) change = contact::larger(change, std::abs(next[i] - left[i]));
        if (change <= tolerance) return change;
        left = k < plain_iterations ? next : accelerated.next(left, next, change);
        for (double& one : left) one = std::clamp(one, least, 1.);
    }
    throw contact::NotConverged(
        fmt::format("steady rolling: after {} iterations friction still follows the slip from one "
                    "state to another: it falls too steeply with the speed of slip for single "
                    "cells; give it a friction.rate.memory_length, or fall less",
                    most_iterations));
}

}  // namespace tricontact::rolling
