#include "contact/solvers/tangential_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/compliances/point_sums.h"
#include "contact/solvers/conjugate_gradients.h"

// Two equations in the step z of the tractions and the shift dU (see the header), residual r:
//
//   [ H   -C ] [ z  ]   [ r ]     H = P A P + D, symmetric and positive definite on z = P z
//   [ C'   0 ] [ dU ] = [ c ]     C: forces of unit tractions; columns of prescribed forces only
//
// Solved by conjugate gradients on the null space of C' (Gould, Hribar and Nocedal 2001). M is the
// compliance's preconditioner, S = C' M^-1 C has two rows at most:
// 1. `carry`: z_0 = M^-1 C S^-1 c carries the missing force.
// 2. `precondition_balanced`: z = M^-1 (r - C lambda), lambda = S^-1 C' M^-1 r, carries no force.
//    What is taken from the residual is what a shift by -lambda takes, so dU follows without a
//    system of its own.
//
// S is singular where all points slip in one direction and no tangent carries more force: the zones
// are refused (`set_zones`), and gradients go on.
//
// Inner products are weighted by the points' areas: in these A is self-adjoint, see Compliance.

namespace tricontact::contact {

/// E follows from turning (0, 0, 1) to the normal (-slope, 1)/n: D = 1 - slope slope'/(n (n + 1)).
Tilt::Tilt(const TangentialField& slope) : parts_(slope.size()) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const auto [x, y] = slope.at(i);
        const double n = std::sqrt(1 + x * x + y * y), factor = 1 / (n * (n + 1));
        parts_[i] = {1 - factor * x * x, -factor * x * y, 1 - factor * y * y};
    }
}

Tilt Tilt::among(const std::vector<std::size_t>& points) const {
    Tilt some;
    if (parts_.empty()) return some;
    for (const std::size_t i : points) some.parts_.push_back(parts_[i]);
    return some;
}

TangentialSystem::TangentialSystem(const Compliance& compliance,
                                   const std::vector<std::size_t>& active,
                                   const ActiveOperator& products,
                                   std::array<bool, 2> force_controlled, Tilt tilt)
    : local_(compliance.local_tangential()),
      products_(products),
      points_(active.size(), compliance.n_threads()),
      force_controlled_(force_controlled),
      tilt_(std::move(tilt)),
      areas_(active.size()),
      scaling_(active.size()) {
    points_.for_points([&](std::size_t k) { areas_[k] = compliance.points().area[active[k]]; });
    area_ = points_.sum_points<double>([&](double& sum, std::size_t k) { sum += areas_[k]; });
    for (auto* field : {&constraint_[0], &constraint_[1], &preconditioned_[0], &preconditioned_[1],
                        &result_.z, &result_.a_z, &residual_, &direction_, &a_direction_,
                        &h_direction_, &z_, &scaled_, &under_layer_})
        *field = TangentialField(active.size());
}

bool TangentialSystem::set_zones(Zones zones) {
    zones_ = std::move(zones);
    radial_scaling_.resize(zones_.radial.size());
    // Points held by a large curvature hardly move: the scaling tells the preconditioner so.
    points_.for_points([&](std::size_t k) {
        const auto part = [&](double resistance) {
            return std::sqrt(local_ / (local_ + resistance));
        };
        scaling_[k] = zones_.slipping[k] || flows(k) ? part(zones_.curvature[k]) : 1;
        if (flows(k)) radial_scaling_[k] = part(zones_.radial[k]);
    });
    find_layer();

    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        points_.for_points([&](std::size_t k) {
            const Vector2 moved = tilt_.apply(k, {d == 0 ? 1. : 0., d == 1 ? 1. : 0.});
            constraint_[d].set(k, projected(k, moved));
        });
        precondition(constraint_[d], preconditioned_[d]);
    }
    std::array<std::array<double, 2>, 2> schur{{{1, 0}, {0, 1}}};
    for (int d = 0; d < 2; ++d)
        for (int e = 0; e < 2; ++e)
            if (force_controlled_[d] && force_controlled_[e])
                schur[d][e] = inner(constraint_[d], preconditioned_[e]);
    const double determinant = schur[0][0] * schur[1][1] - schur[0][1] * schur[1][0];
    schur_inverse_ = {{{schur[1][1] / determinant, -schur[0][1] / determinant},
                       {-schur[1][0] / determinant, schur[0][0] / determinant}}};
    return determinant > 1e-10 * schur[0][0] * schur[1][1];
}

/// What flows yields like a layer over the body, which the products' preconditioner may know. Its
/// directions are alike in most contacts, and so is the matrix of its points: the mean is taken.
void TangentialSystem::find_layer() {
    layer_.reset();
    if (!(zones_.along > 0) || zones_.radial.empty() || !products_.knows_layers()) return;
    const auto [n, n_sticking, xx, xy, yy] =
        points_
            .sum_points<Sums<5>>([&](Sums<5>& sum, std::size_t k) {
                if (!flows(k)) {
                    sum[1] += zones_.slipping[k] ? 0 : 1;
                    return;
                }
                const Vector2 x = resisted(k, {1, 0}), y = resisted(k, {0, 1});
                sum[0] += 1;
                sum[2] += x[0];
                sum[3] += x[1];
                sum[4] += y[1];
            })
            .values;
    all_move_ = n_sticking == 0;
    if (n > 0) layer_ = LayerCompliance{xx / n, xy / n, yy / n};
}

/// What flows as the body under a layer without end. Of waves that are shorter than the zones what
/// flows and what sticks tell each other: half of what the scaling of all points makes of what
/// flows is added. Where no point sticks little is to be told.
void TangentialSystem::precondition_under_layer(const TangentialField& r, TangentialField& z) {
    constexpr double half = .5;
    const double share = all_move_ ? 0 : std::sqrt(half);
    const auto part = [&](std::size_t k, const Vector2& f) {
        return flows(k) ? share * scaled(k, f) : scaled(k, f);
    };
    points_.for_points([&](std::size_t k) { scaled_.set(k, part(k, r.at(k))); });
    products_.precondition(scaled_, z);
    points_.for_points([&](std::size_t k) { z.set(k, projected(k, part(k, z.at(k)))); });
    points_.for_points([&](std::size_t k) { scaled_.set(k, flows(k) ? r.at(k) : Vector2{}); });
    products_.precondition_under(*layer_, scaled_, under_layer_);
    points_.for_points([&](std::size_t k) {
        if (flows(k)) z.set(k, z.at(k) + under_layer_.at(k));
    });
}

void TangentialSystem::precondition(const TangentialField& r, TangentialField& z) {
    if (layer_) return precondition_under_layer(r, z);
    points_.for_points([&](std::size_t k) { scaled_.set(k, scaled(k, r.at(k))); });
    products_.precondition(scaled_, z);
    points_.for_points([&](std::size_t k) { z.set(k, projected(k, scaled(k, z.at(k)))); });
}

/// Of what flows along its traction what it comes to in tractions (Zones::along): a layer that is
/// much softer than the body would multiply rounding.
double TangentialSystem::rms_residual() const {
    if (zones_.radial.empty()) return std::sqrt(inner(residual_, residual_) / area_);
    const double sum = points_.sum_terms([&](std::size_t k) {
        const Vector2 r = residual_.at(k);
        const double along =
            zones_.along > 0 ? zones_.along : radial_scaling_[k] * radial_scaling_[k];
        const Vector2 weighed = flows(k) ? stretched(k, r, 1, along) : r;
        return areas_[k] * dot(weighed, weighed);
    });
    return std::sqrt(sum / area_);
}

double TangentialSystem::inner(const TangentialField& a, const TangentialField& b) const {
    return points_.sum_terms(
        [&](std::size_t k) { return areas_[k] * (a.x[k] * b.x[k] + a.y[k] * b.y[k]); });
}

Vector2 TangentialSystem::total(const TangentialField& z) const {
    Vector2 sum{};
    for (int d = 0; d < 2; ++d)
        sum[d] = points_.sum_terms([&](std::size_t k) {
            return areas_[k] *
                   (tilt_.is_plane() ? (d == 0 ? z.x[k] : z.y[k]) : tilt_.apply(k, z.at(k))[d]);
        });
    return sum;
}

Vector2 TangentialSystem::constraint_multiplier(const Vector2& force) const {
    Vector2 rhs = force;
    for (int d = 0; d < 2; ++d)
        if (!force_controlled_[d]) rhs[d] = 0;
    Vector2 lambda = {schur_inverse_[0][0] * rhs[0] + schur_inverse_[0][1] * rhs[1],
                      schur_inverse_[1][0] * rhs[0] + schur_inverse_[1][1] * rhs[1]};
    for (int d = 0; d < 2; ++d)
        if (!force_controlled_[d]) lambda[d] = 0;
    return lambda;
}

const TangentialSystem::Result& TangentialSystem::solve(const TangentialField& r, const Vector2& c,
                                                        const Limits& limits) {
    start(r);
    carry(c);
    std::optional<double> target;
    conjugate_gradients(
        limits.iterations - result_.iterations,
        [&] {
            precondition_balanced();
            if (!target) target = std::max(limits.absolute, limits.relative * rms_residual());
            return rms_residual() <= *target;
        },
        [&] { return inner(residual_, z_); }, [&](double beta) { turn(beta); },
        [&] {
            apply();
            return inner(direction_, h_direction_);
        },
        [&](double step) { move(step); });
    return result_;
}

void TangentialSystem::start(const TangentialField& r) {
    result_.iterations = 0;
    result_.shift_increment = {};
    points_.for_points([&](std::size_t k) {
        residual_.set(k, projected(k, r.at(k)));
        for (auto* field : {&result_.z, &result_.a_z, &direction_}) field->set(k, {0, 0});
    });
}

void TangentialSystem::move(double step) {
    points_.for_points([&](std::size_t k) {
        result_.z.set(k, result_.z.at(k) + step * direction_.at(k));
        result_.a_z.set(k, result_.a_z.at(k) + step * a_direction_.at(k));
        residual_.set(k, residual_.at(k) - step * h_direction_.at(k));
    });
}

void TangentialSystem::turn(double beta) {
    points_.for_points(
        [&](std::size_t k) { direction_.set(k, z_.at(k) + beta * direction_.at(k)); });
}

/// A particular solution that carries the force `c`; all that follows leaves the force as it is.
void TangentialSystem::carry(const Vector2& c) {
    const Vector2 lambda = constraint_multiplier(c);
    if (lambda[0] == 0 && lambda[1] == 0) return;
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d])
            points_.for_points([&](std::size_t k) {
                direction_.set(k, direction_.at(k) + lambda[d] * preconditioned_[d].at(k));
            });
    apply();
    move(1);
}

/// H d = P A d + D d.
void TangentialSystem::apply() {
    products_.apply_roughly(direction_, a_direction_);
    ++result_.iterations;
    points_.for_points([&](std::size_t k) {
        h_direction_.set(k, projected(k, a_direction_.at(k)) + resisted(k, direction_.at(k)));
    });
}

/// Gives the rigid shift the part of the residual that it can cancel, so that z is balanced.
void TangentialSystem::precondition_balanced() {
    precondition(residual_, z_);
    const Vector2 lambda = constraint_multiplier(total(z_));
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        points_.for_points([&](std::size_t k) {
            residual_.set(k, residual_.at(k) - lambda[d] * constraint_[d].at(k));
            z_.set(k, z_.at(k) - lambda[d] * preconditioned_[d].at(k));
        });
        result_.shift_increment[d] -= lambda[d];
    }
}

}  // namespace tricontact::contact
