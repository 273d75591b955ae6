#include "rolling/rate_friction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

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
    const double time = grid.spacing[0] / speed;  // over a cell
    const auto left_of_cell = [&rate, at_rest, time](double v, double ahead) {
        if (v == 0 && ahead == 1) return 1.;  // most cells
        const double kept = rate.memory(time, v);
        return kept * ahead + (1 - kept) * rate.coefficient(at_rest, v) / at_rest;
    };
    // From the leading edge on: a cell, its speed, what the one ahead has left.
    const auto for_cells = [&grid, speed, left_of_cell](const SteadySolution& solution,
                                                        const auto& action) {
        for (int row = 0; row < grid.n_y; ++row) {
            double ahead = 1;
            for (int i = grid.n_x - 1; i >= 0; --i) {
                const std::size_t k = static_cast<std::size_t>(row) * grid.n_x + i;
                const double v = speed * contact::norm(solution.slip.at(k));
                action(k, v, ahead);
                ahead = left_of_cell(v, ahead);
            }
        }
    };
    const auto left = [&grid, for_cells, left_of_cell](const SteadySolution& solution) {
        std::vector<double> all(grid.size());
        for_cells(solution,
                  [&](std::size_t k, double v, double ahead) { all[k] = left_of_cell(v, ahead); });
        return all;
    };
    const auto slopes = [&grid, &rate, for_cells, left_of_cell, time,
                         speed](const SteadySolution& solution) {
        constexpr double apart = 1e-6;  // of the speed: half the digits
        BoundSlopes all{std::vector<double>(grid.size()), std::vector<double>(grid.size())};
        for_cells(solution, [&](std::size_t k, double v, double ahead) {
            all.ahead[k] = rate.memory(time, v);
            if (!(v > 0)) return;
            const double more = v * (1 + apart), less = v * (1 - apart);
            all.own[k] =
                speed * (left_of_cell(more, ahead) - left_of_cell(less, ahead)) / (more - less);
        });
        return all;
    };
    // Each law by d_k/v_k at most.
    double steepest = 0;
    for (std::size_t k = 0; k < rate.drops.size(); ++k)
        steepest += rate.drops[k] / rate.speeds[k] * speed / at_rest;
    return {left,
            rate.least(at_rest) / at_rest,
            "falls with the speed of slip",
            "give it a friction.rate.memory_length, or fall less",
            slopes,
            steepest};
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

namespace {

// Of the last change of mu, how exactly the state under it is solved for the next one: while
// changes are a good part of all that mu may lose, then, and where iterates are combined. A change
// is believed down to this part of what the state's own exactness leaves open. From which changes
// on Newton's method is tried, with how many steps.
constexpr double of_first_changes = .9, of_change = .3, of_combined_changes = .1;
constexpr double far_off = .3, believed = .5;
constexpr double close_by = .15;
constexpr int most_tries = 4;
constexpr int newton_steps = 8;
// Those next to a point that lets go let go as well.
constexpr double with_its_neighbours = 1.15;
constexpr int steps_before_another_try = 6;

/// The search for a state, field of mu after field of mu.
class Search {
  public:
    Search(const contact::Compliance& compliance, const SteadyProblem& problem,
           const ChangingFriction& friction, double tolerance, SteadySolution& solution,
           std::vector<double>& left, SlipStart from, const SteadySolution* other)
        : compliance_(compliance),
          problem_(problem),
          friction_(friction),
          tolerance_(tolerance),
          solution_(solution),
          left_(left),
          other_(other),
          range_(std::abs(1 - friction.in_the_end)) {
        double bound = 0, n = 0;
        for (const double one : problem.bound)
            if (one > 0) bound += one, ++n;
        const double local = compliance.local_tangential() / compliance.points().spacing[0];
        if (from == SlipStart::slow) alone_ = with_its_neighbours * friction.slip_alone;
        if (n > 0) steepness_ = std::max(1., friction.steepest * local * bound / n);
    }

    double run() {
        const auto [lowest, highest] = std::minmax({1., friction_.in_the_end});
        contact::OneSidedFixedPoint iteration;
        int n_tries = 0, next_try = 0;
        // Change. From another state's tractions the first iterate shall not stay where they are.
        double before = other_ ? .1 : 1;
        bool is_far = alone_ > 0;
        for (int k = 0; k < contact::OneSidedFixedPoint::max_iterations; ++k) {
            is_far = is_far && before > far_off * range_;
            const double share = is_far                ? of_first_changes
                                 : k < iteration.first ? of_change
                                                       : of_combined_changes;
            const double asked = std::max(tolerance_, share / steepness_ * before);
            solve(asked, k == 0);
            const std::vector<double> next = friction_next();
            const double change = largest_change(next);
            if (change <= tolerance_ && asked == tolerance_) return change;
            // A smaller one says how coarsely the state is solved, not how near it is.
            const double told = std::max(change, believed * steepness_ * asked);
            const bool contracts = told < before && told < close_by * range_;
            if (friction_.slopes && contracts && k >= next_try && n_tries < most_tries) {
                for (const SteadySolution* from : {other_, &std::as_const(solution_)})
                    if (const auto left_over = try_newton(from, next, told, told / before))
                        return *left_over;
                next_try = k + (steps_before_another_try << n_tries++);
            }
            before = told;
            left_ = iteration.next(left_, next, change);
            for (double& one : left_) one = std::clamp(one, lowest, highest);
        }
        throw contact::NotConverged(fmt::format(
            "steady rolling: after {} iterations friction still follows the slip from one "
            "state to another: it {} too steeply for single cells; {}",
            contact::OneSidedFixedPoint::max_iterations, friction_.changes, friction_.remedy));
    }

  private:
    /// The steady state under the present mu.
    void solve(double tolerance, bool is_first) {
        std::vector<double> bound(left_.size());
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = left_[i] * problem_.bound[i];
        SteadyTolerances tolerances{tolerance};
        if (tolerance > tolerance_) tolerances.force = of_change * tolerance;
        const int before = is_first ? 0 : solution_.iterations;
        try {
            solve_steady(compliance_,
                         {bound, problem_.displacement, problem_.drive, problem_.centre,
                          problem_.slip_unit, problem_.stick_inverse},
                         tolerances, solution_);
        } catch (const contact::InputError&) {
            if (is_first) throw;  // at rest, too
            throw contact::InputError(fmt::format(
                "rolling: the force {:.6g} N is more than friction carries that {} ({:.6g} N at "
                "rest); lower it, or prescribe the creepage",
                contact::norm(problem_.drive.force), friction_.changes,
                carried_at_rest(compliance_.points(), problem_)));
        }
        solution_.iterations += before;
    }

    /// The solution without what its tolerance leaves of slip where points stick.
    SteadySolution told() const {
        SteadySolution told = solution_;
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (contact::norm(told.traction.at(i)) < left_[i] * problem_.bound[i] * (1 - 1e-9))
                told.slip.set(i, {0, 0});
        return told;
    }

    /// What the slip of this state leaves of friction, each point with the slip that it adds to its
    /// own as it lets go, by itself: on the same side as without, in a fraction of the iterates.
    /// From fast slip, where points come to rest instead, some would too early.
    std::vector<double> friction_next() const {
        constexpr int times = 6;
        SteadySolution here = told();
        const contact::TangentialField slip = here.slip;
        std::vector<double> next = friction_.left(here);
        if (alone_ == 0) return next;
        for (int k = 0; k < times; ++k) {
            for (std::size_t i = 0; i < next.size(); ++i) {
                const double length = contact::norm(slip.at(i));
                if (!(length > 0)) continue;
                const double added = alone_ * problem_.bound[i] * (left_[i] - next[i]);
                const double share = std::max(0., 1 + added / length);
                here.slip.set(i, {share * slip.x[i], share * slip.y[i]});
            }
            next = friction_.left(here);
        }
        return next;
    }

    double largest_change(const std::vector<double>& next) const {
        double change = 0;
        for (std::size_t i = 0; i < next.size(); ++i)
            if (problem_.bound[i] > 0)
                change = contact::larger(change, std::abs(next[i] - left_[i]));
        return change;
    }

    /// Newton's method on tractions and mu together, after an iterate whose `next` is known, by a
    /// `change` that is `factor` times the one before; `from` that one, or a state. Taken where it
    /// arrives no farther away than iterates that go on so could lead, and on their side; else
    /// null, and nothing changes.
    std::optional<double> try_newton(const SteadySolution* from, const std::vector<double>& next,
                                     double change, double factor) {
        if (!from) return {};
        SteadySolution found = *from;
        const FollowingBound following{friction_.left, friction_.slopes};
        SteadyNewton newton(compliance_, problem_, {tolerance_}, found, &following);
        try {
            newton.run(newton_steps);
        } catch (const contact::NotConverged&) {
            return {};
        }
        const std::vector<double> left = newton.left();
        double along = 0;
        for (std::size_t i = 0; i < left.size(); ++i)
            along += problem_.bound[i] * (left[i] - left_[i]) * (next[i] - left_[i]);
        const double unknown =
            alone_ > 0 ? of_change * change / factor : 0;  // by the tolerance of the state
        if (!(along > 0) || largest_change(left) > 2 * (change + unknown) / (1 - factor)) return {};
        found.iterations += solution_.iterations;
        solution_ = std::move(found);
        left_ = left;
        return largest_change(friction_.left(solution_));
    }

    const contact::Compliance& compliance_;
    const SteadyProblem& problem_;
    const ChangingFriction& friction_;
    const double tolerance_;
    SteadySolution& solution_;
    std::vector<double>& left_;
    const SteadySolution* const other_;
    const double range_;    // of what is left
    double alone_ = 0;      // slip_alone and a little more; 0: points follow together alone
    double steepness_ = 1;  // change of mu over the residual of the state that it follows [-]
};

}  // namespace

double slip_alone(const contact::Compliance& compliance) {
    const contact::ContactPoints& points = compliance.points();
    const std::size_t middle = points.size() / 2;
    contact::TangentialField t(points.size()), u(points.size());
    t.set(middle, {1, 1});
    compliance.tangential(t, u);
    const contact::Vector2 here = u.at(middle), ahead = u.at(middle + 1);
    return std::min(here[0] - ahead[0], here[1] - ahead[1]) / points.spacing[0];
}

double solve_steady_rated(const contact::Compliance& compliance, const SteadyProblem& problem,
                          const ChangingFriction& friction, SlipStart from, double tolerance,
                          SteadySolution& solution, std::vector<double>& left,
                          const SteadySolution* other) {
    if (left.empty())
        left.assign(problem.bound.size(), from == SlipStart::slow ? 1 : friction.in_the_end);
    return Search(compliance, problem, friction, tolerance, solution, left, from, other).run();
}

}  // namespace tricontact::rolling
