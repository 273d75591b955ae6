// Of tangential_solver.cc alone: the iteration on one problem.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/compliances/blocks.h"
#include "contact/compliances/point_sums.h"
#include "contact/solvers/projected_gradient.h"
#include "contact/solvers/tangential_solver.h"

namespace tricontact::contact {

/// See TangentialSolver.
class TangentialNewton {
  public:
    TangentialNewton(const Compliance& compliance, const std::vector<std::size_t>& active,
                     const ActiveOperator& products, const TangentialProblem& problem,
                     double tolerance, TangentialSolution& solution)
        : compliance_(compliance),
          active_(active),
          products_(products),
          problem_(problem),
          tilt_(problem.tilt.among(active)),
          tolerance_(problem.looseness * tolerance),
          force_tolerance_(problem.looseness * force_tolerance),
          alpha_(problem.contact_compliance),
          zone_alpha_(problem.zone_compliance(compliance.local_tangential())),
          is_layer_(problem.hardening && 1 / problem.hardening->slope < softest * alpha_),
          solution_(solution),
          points_(active.size(), compliance.n_threads()),
          all_points_(compliance.points().size(), compliance.n_threads()),
          area_(active.size()),
          disc_(active.size()),
          traction_(active.size()),
          previous_(active.size()),
          displacement_(active.size()),
          slip_(active.size()) {
        points_.for_points([&](std::size_t k) {
            area_[k] = compliance.points().area[active_[k]];
            disc_[k] = problem.disc(active_[k]);
            previous_.set(k, problem.previous_displacement.at(active_[k]));
        });
        for (int d = 0; d < 2; ++d)
            force_controlled_[d] = problem.control[d].kind == TangentialControl::Kind::force;
        sum_bounds();
        check_force_is_carried();
        system_.emplace(compliance_, active_, products_, force_controlled_, tilt_);
    }

    void run() {
        solution_.iterations = 0;
        start();
        double best = infinity;
        for (int step = 0; step < max_newton_steps; ++step) {
            if (step > 0 && seems_converged())
                update_slip_and_all();
            else
                update_slip();
            update_residual();
            // A start taken as it is would bring its error back in each period: a drift.
            if (converged() && !(step == 0 && shift_is_given_)) {
                if (!problem_.displaces_all)
                    hand_over();
                else if (!displaces_all_)
                    update_slip_and_all();
                return;
            }
            without_progress_ = solution_.residual < 0.9 * best ? 0 : without_progress_ + 1;
            best = std::min(best, solution_.residual);
            if (without_progress_ >= patience || !solve_linear_system()) {
                take_gradient_steps();
                without_progress_ = 0;
                best = infinity;
            }
            classify();
        }
        throw NotConverged(
            fmt::format("tangential contact: residual {:.2e} (tolerance {:.1e}), force residual "
                        "{:.2e} after {} "
                        "Newton steps; {} points in contact, {} slipping",
                        solution_.residual, tolerance_, solution_.force_residual, max_newton_steps,
                        active_.size(), std::ranges::count(zone_, FrictionDisc::Zone::slip)));
    }

  private:
    static constexpr int max_newton_steps = 200;
    static constexpr int patience = 8;  // Newton steps without progress before gradients take over
    static constexpr int gradient_iterations = 60;  // at first, twice as many each time, up to
    static constexpr int most_gradient_iterations = 64 * gradient_iterations;
    static constexpr int cg_iterations = 300;
    // Of a layer over the contact's compliance: softer ones flow farther than the contact is wide,
    // and how far differs more than a mean can tell.
    static constexpr double softest = 1e3;
    static constexpr double force_tolerance =
        1e-10;  // over sum bound A; ten times finer than promised

    using Zone = FrictionDisc::Zone;

    void sum_bounds() {
        const auto [bound, area] = points_
                                       .sum_points<Sums<2>>([&](Sums<2>& sum, std::size_t k) {
                                           sum[0] += area_[k] * disc_[k].bound;
                                           sum[1] += area_[k];
                                       })
                                       .values;
        total_bound_ = bound;
        mean_bound_ = total_bound_ / area;
    }

    void check_force_is_carried() const {
        Vector2 force{};
        for (int d = 0; d < 2; ++d)
            if (force_controlled_[d]) force[d] = problem_.control[d].value;
        if (norm(force) >= total_bound_)
            throw InputError(fmt::format(
                "tangential contact: the force {:.6g} N reaches the friction limit {:.6g} N: the "
                "contact slides as a whole; lower the tangential force",
                norm(force), total_bound_));
    }

    /// Starts from the given traction; points that it loads to the bound slip at first. A given
    /// shift increment tells better which do.
    void start() {
        const std::size_t n = compliance_.points().size();
        if (solution_.traction.size() != n) solution_.traction = TangentialField(n);
        solution_.displacement.x.resize(n);
        solution_.displacement.y.resize(n);
        take_over();
        zone_.resize(active_.size());
        points_.for_points([&](std::size_t k) {
            zone_[k] = disc_[k].zone_of(norm(traction_.at(k)));
            traction_.set(k, project_on_disc(traction_.at(k), disc_[k].bound));
        });
        for (int d = 0; d < 2; ++d)
            if (force_controlled_[d])
                shift_is_given_ |= solution_.shift_increment[d] != 0;
            else
                solution_.shift_increment[d] = problem_.control[d].value;
        if (!shift_is_given_) return;
        products_.apply_roughly(traction_, displacement_);
        ++solution_.iterations;
        slip_by_displacement();
        classify();
    }

    void take_over() {
        points_.for_points(
            [&](std::size_t k) { traction_.set(k, solution_.traction.at(active_[k])); });
    }

    void hand_over() {
        all_points_.for_points([&](std::size_t i) { solution_.traction.set(i, {0, 0}); });
        points_.for_points(
            [&](std::size_t k) { solution_.traction.set(active_[k], traction_.at(k)); });
    }

    void update_slip() {
        products_.apply(traction_, displacement_);
        ++solution_.iterations;
        displaces_all_ = false;
        slip_by_displacement();
    }

    /// By the displacements of all points, which a solution needs too.
    void update_slip_and_all() {
        hand_over();
        compliance_.tangential(solution_.traction, solution_.displacement);
        ++solution_.iterations;
        displaces_all_ = true;
        points_.for_points(
            [&](std::size_t k) { displacement_.set(k, solution_.displacement.at(active_[k])); });
        slip_by_displacement();
    }

    void slip_by_displacement() {
        points_.for_points([&](std::size_t k) {
            slip_.set(k, tilt_.apply(k, solution_.shift_increment) +
                             (previous_.at(k) - displacement_.at(k)));
        });
    }

    /// t + s/alpha: inside the friction disc where the point sticks.
    Vector2 trial(std::size_t k, double a) const { return traction_.at(k) + slip_.at(k) / a; }

    void update_residual() {
        if (problem_.hardening) sum_present_bounds();
        const auto [worst, force, on_bound] =
            points_.sum_points<Misfit>([&](Misfit& sum, std::size_t k) {
                const Vector2 t = traction_.at(k), y = trial(k, alpha_);
                const FrictionDisc& disc = disc_[k];
                sum.worst = larger(sum.worst, norm(t - disc.project(y, alpha_)));
                // A start from other bounds may be close and yet slip below the bound: not
                // accepted.
                const double size = norm(y);
                sum.on_bound = sum.on_bound && (size <= disc.at_start ||
                                                norm(t) >= disc.least(size, alpha_) * (1 - 1e-11));
                sum.force = sum.force + area_[k] * tilt_.apply(k, t);
            });
        on_bound_ = on_bound;
        solution_.residual = worst / mean_bound_;
        solution_.force_residual = 0;
        for (int d = 0; d < 2; ++d) {
            missing_force_[d] = force_controlled_[d] ? problem_.control[d].value - force[d] : 0;
            solution_.force_residual =
                larger(solution_.force_residual, std::abs(missing_force_[d]) / total_bound_);
        }
    }

    /// The scale of residuals, where bounds rise: what points carry that have flowed so far.
    void sum_present_bounds() {
        const auto [bound, area] =
            points_
                .sum_points<Sums<2>>([&](Sums<2>& sum, std::size_t k) {
                    sum[0] += area_[k] * std::max(norm(traction_.at(k)), disc_[k].at_start);
                    sum[1] += area_[k];
                })
                .values;
        total_bound_ = bound;
        mean_bound_ = bound / area;
    }

    /// As far as the slip that the last step left tells. A dense matrix of all points is not worth
    /// a guess.
    bool seems_converged() {
        if (compliance_.dense()) return false;
        update_residual();
        return converged();
    }

    bool converged() const {
        return on_bound_ && solution_.residual <= tolerance_ &&
               solution_.force_residual <= force_tolerance_;
    }

    /// One Newton step on the present zones; false when they cannot carry the force.
    bool solve_linear_system() {
        TangentialSystem::Zones zones{std::vector<std::uint8_t>(active_.size()),
                                      std::vector<Vector2>(active_.size()),
                                      std::vector<double>(active_.size(), 0.0),
                                      {}};
        TangentialField flowed;
        const double slope = problem_.hardening ? problem_.hardening->slope : 0;
        if (problem_.hardening) {
            zones.radial.resize(active_.size(), 0.0);
            zones.along = is_layer_ ? alpha_ / (alpha_ + 1 / slope) : 0;
            flowed = slip_;
        }
        points_.for_points([&](std::size_t k) {
            if (zone_[k] == Zone::stick) return;
            const Vector2 t = traction_.at(k);
            const double size = zone_[k] == Zone::flow ? norm(t) : disc_[k].bound;
            zones.tangent[k] = {-t[1] / size, t[0] / size};
            zones.slipping[k] = zone_[k] == Zone::slip;
            if (zone_[k] == Zone::slip) {
                zones.curvature[k] = std::max(0.0, dot(slip_.at(k), t) / size) / size;
                return;
            }
            const double way = (size - disc_[k].at_start) / slope;
            zones.radial[k] = 1 / slope;
            // Tractions just above the start tell of no way yet: slips do.
            const double slipped = is_layer_ ? dot(slip_.at(k), t) / size : 0;
            zones.curvature[k] = std::max({0.0, way, slipped}) / size;
            flowed.set(k, slip_.at(k) - (way / size) * t);
        });
        if (!system_->set_zones(std::move(zones))) return false;
        const double scale = alpha_ * mean_bound_;
        // Zones still move while the residual is large: solve no more exactly than that deserves.
        const double forcing = std::clamp(std::sqrt(solution_.residual), 1e-3, 0.3);
        // Rotating slipping tractions costs force in the second order: keep the rotations small.
        // The system's residual is a mean, ours a maximum: go finer where that makes the
        // difference.
        const double fine = std::min(tolerance_, 0.01 * std::sqrt(force_tolerance_)) *
                            std::pow(0.1, without_progress_);
        const auto& result = system_->solve(
            problem_.hardening ? flowed : slip_, missing_force_,
            {.relative = forcing, .absolute = 0.1 * fine * scale, .iterations = cg_iterations});
        solution_.iterations += result.iterations;
        // Where all slip in the direction of the force, hardly any rotation carries more of it.
        const double farthest =
            1e3 * (scale + norm(solution_.shift_increment)) + (slope > 0 ? mean_bound_ / slope : 0);
        if (!(norm(result.shift_increment) <= farthest)) return false;
        move(result);
        return true;
    }

    void move(const TangentialSystem::Result& result) {
        solution_.shift_increment = solution_.shift_increment + result.shift_increment;
        points_.for_points([&](std::size_t k) {
            Vector2 t = traction_.at(k) + result.z.at(k);
            if (zone_[k] == Zone::slip) t = onto_edge(t, disc_[k].bound);
            traction_.set(k, t);
            slip_.set(k, slip_.at(k) + (tilt_.apply(k, result.shift_increment) - result.a_z.at(k)));
        });
    }

    /// New zones from traction and slip; slipping points are put on their friction disc.
    void classify() {
        points_.for_points([&](std::size_t k) {
            const Vector2 y = trial(k, zone_alpha_);
            const Zone before = std::exchange(zone_[k], disc_[k].zone(norm(y), zone_alpha_));
            traction_.set(k, disc_[k].started(zone_[k], before, traction_.at(k), y, zone_alpha_));
        });
    }

    void take_gradient_steps();

    const Compliance& compliance_;
    const std::vector<std::size_t>& active_;
    const ActiveOperator& products_;
    const TangentialProblem& problem_;
    const Tilt tilt_;
    const double tolerance_, force_tolerance_;
    const double alpha_, zone_alpha_;  // of the contact; what tells the zones [m/Pa]
    const bool is_layer_;              // what flows is not far softer than the contact
    TangentialSolution& solution_;
    std::array<bool, 2> force_controlled_{};
    const Blocks points_, all_points_;  // active ones
    // Per active point: areas [m^2], discs and tractions [Pa]; displacements before and now [m].
    std::vector<double> area_;
    std::vector<FrictionDisc> disc_;
    TangentialField traction_, previous_, displacement_;
    TangentialField slip_;  // s [m]
    std::vector<Zone> zone_;
    std::optional<TangentialSystem> system_;
    Vector2 missing_force_{};
    int without_progress_ = 0;  // Newton steps
    int gradient_iterations_ = gradient_iterations;
    TangentialSolution descended_;  // by gradients
    bool on_bound_ = false;         // all that slip are
    bool displaces_all_ = false;    // the last product was with all points
    bool shift_is_given_ = false;
    double total_bound_ = 0, mean_bound_ = 0;
};

}  // namespace tricontact::contact
