// Bounds of friction: of the present pressures, and where friction remembers how far points have
// slipped those that follow the slip of the step.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/compliances/point_sums.h"
#include "contact/friction/carried_friction.h"
#include "contact/solvers/fixed_point.h"
#include "contact/solvers/staggered_solver.h"

namespace tricontact::contact {

namespace {

/// Of bounds, over their mean: states in which a point differs by more are others.
constexpr double unlike = 1e-3;

}  // namespace

/// Of the present pressures. The area on which friction acts [m^2].
double StaggeredSolver::update_bounds() {
    const auto* const carried = dynamic_cast<const CarriedFriction*>(friction_.get());
    const auto [area, bound] =
        blocks()
            .sum<Sums<2>>([&](std::size_t, std::size_t begin, std::size_t end) {
                const std::size_t n = end - begin;
                const std::span<const double> share = now_.normal->share;
                const FrictionLaw::Points pressed{
                    std::span(now_.normal->pressure).subspan(begin, n),
                    std::span(points().x).subspan(begin, n),
                    std::span(points().y).subspan(begin, n)};
                const std::span<double> bounds = std::span(now_.bound).subspan(begin, n);
                if (carried)
                    carried->bounds_beside(
                        pressed, std::span(now_.tangential.traction.x).subspan(begin, n), bounds);
                else
                    bounds_on_shares(*friction_, pressed,
                                     share.empty() ? share : share.subspan(begin, n), bounds);
                Sums<2> sum;
                for (std::size_t i = begin; i < end; ++i) {
                    if (chatter_.is_watched() && chatter_.lets_go(i, now_.normal->pressure[i] > 0))
                        now_.bound[i] = 0;
                    if (now_.bound[i] > 0) sum[0] += points().area[i];
                    sum[1] += points().area[i] * now_.bound[i];
                }
                return sum;
            })
            .values;
    now_.total_bound = bound;
    return area;
}

/// Bounds by the ways of points [Pa]; those that carry nothing `at_rest` do not, whatever they
/// slip.
std::vector<double> StaggeredSolver::bounds_by_way(const std::vector<double>& way,
                                                   const std::vector<double>& at_rest) const {
    std::vector<double> bound(at_rest.size());
    friction_->bounds({now_.normal->pressure, points().x, points().y, way}, bound);
    for (std::size_t i = 0; i < bound.size(); ++i)
        if (!(at_rest[i] > 0)) bound[i] = 0;
    return bound;
}

/// A layer that flows and hardens: what it carries in the step rises with its flow from what it has
/// carried before up to what the surfaces do, and is solved for together with the tractions. Flow
/// is told by the tractions: where the layer hardens steeply it is less than slips are known to.
void StaggeredSolver::harden(const LoadStep& step, const StepStart& before, double contact_area) {
    const std::vector<double> at_start = bounds_by_way(before.way, now_.bound);
    const Hardening hardening{at_start, friction_->hardening() / substrate_.stiffness()};
    solve_under_bounds(step, before, contact_area, &hardening);
    blocks().for_points([&](std::size_t i) {
        const double carried = norm(now_.tangential.traction.at(i));
        now_.bound[i] = std::clamp(carried, at_start[i], now_.bound[i]);
        now_.way[i] = before.way[i] + (now_.bound[i] - at_start[i]) / friction_->hardening();
    });
}

/// The ways of points after the present solution's slip.
void StaggeredSolver::update_way(const StepStart& before) {
    const TangentialField old = displaced_before(before);
    const double stiffness = substrate_.stiffness();
    blocks().for_points([&](std::size_t i) {
        const double pressure = now_.normal->pressure[i];
        now_.way[i] = friction_->healed(before.way[i]);
        if (!(pressure > 0)) return;
        const Vector2 moved = (old.at(i) - now_.tangential.displacement.at(i)) / stiffness;
        const Vector2 slip = now_.tangential.shift_increment + moved - before_touch(i);
        now_.way[i] = friction_->way(before.way[i], norm(slip), pressure);
    });
}

/// A fixed point of the bounds from those of `way` on, each step of which is the contact under
/// given ones. Throws InputError when the force is more than what slips carries, NotConverged.
void StaggeredSolver::settle_bounds(const LoadStep& step, const StepStart& before,
                                    const std::vector<double>& at_rest, double contact_area) {
    const double mean = now_.total_bound / contact_area;
    now_.bound = bounds_by_way(now_.way, at_rest);
    OneSidedFixedPoint iteration;
    for (int k = 0; k < OneSidedFixedPoint::max_iterations; ++k) {
        solve_under_bounds(step, before, contact_area);
        update_way(before);
        std::vector<double> next = bounds_by_way(now_.way, at_rest);
        double change = 0;
        for (std::size_t i = 0; i < next.size(); ++i)
            change = larger(change, std::abs(next[i] - now_.bound[i]) / mean);
        if (change <= looseness_ * tolerance_) return;
        next = iteration.next(now_.bound, next, change);
        for (double& bound : next) bound = std::max(bound, 0.);
        now_.bound = std::move(next);
    }
    throw NotConverged(fmt::format(
        "{}: after {} iterations the bounds of friction still follow the slip from one state to "
        "another at phase {:.4g}; take smaller steps, or let the bound change less with the slip",
        name_, OneSidedFixedPoint::max_iterations, step.phase));
}

/// From the slip at the start of the step bounds that fall with it fall from one iterate to the
/// next and slip grows: what they come to is the state of least slip, which the last one goes over
/// into as the load grows, and where that ends the next one, into which the contact jumps.
void StaggeredSolver::follow_slip(const LoadStep& step, const StepStart& before,
                                  double contact_area) {
    const std::vector<double> at_rest = now_.bound;
    try {
        settle_bounds(step, before, at_rest, contact_area);
    } catch (const InputError&) {
        const double force = prescribed_force(forces_and_shifts(step));
        if (force >= now_.total_bound) throw;
        throw InputError(fmt::format(
            "{}: the force {:.6g} N is more than friction carries that falls with the slip ({:.6g} "
            "N at rest): the contact slides as a whole; lower it, or prescribe the shift",
            name_, force, now_.total_bound));
    }
    if (looseness_ == 1)
        now_.may_differ =
            friction_->weakens() && may_slip_more(step, before, at_rest, contact_area);
}

/// Whether the state of most slip, to which bounds come that begin with those of endless slip, is
/// another one than the present, or cannot be told. A force that they do not carry at all is held
/// by what has not slipped yet: what shakes the contact may let it slide away.
bool StaggeredSolver::may_slip_more(const LoadStep& step, const StepStart& before,
                                    const std::vector<double>& at_rest, double contact_area) {
    ContactSolution least = now_;
    bool differs = false;
    try {
        now_.way.assign(now_.way.size(), infinity);
        settle_bounds(step, before, at_rest, contact_area);
        double change = 0;
        for (std::size_t i = 0; i < at_rest.size(); ++i)
            change = larger(change, std::abs(now_.bound[i] - least.bound[i]));
        differs = change > unlike * least.total_bound / contact_area;
    } catch (const InputError&) {
        differs = true;
    } catch (const NotConverged&) {
        differs = true;
    }
    const int iterations = now_.tangential_iterations;
    now_ = std::move(least);
    now_.tangential_iterations = iterations;
    return differs;
}

}  // namespace tricontact::contact
