#include "contact/solvers/tangential_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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
      force_controlled_(force_controlled),
      tilt_(std::move(tilt)),
      scaling_(active.size()) {
    for (const std::size_t i : active) areas_.push_back(compliance.points().area[i]);
    for (const double area : areas_) area_ += area;
    for (auto* field :
         {&constraint_[0], &constraint_[1], &preconditioned_[0], &preconditioned_[1], &result_.z,
          &result_.a_z, &residual_, &direction_, &a_direction_, &h_direction_, &z_, &scaled_})
        *field = TangentialField(active.size());
}

bool TangentialSystem::set_zones(const std::vector<std::uint8_t>& slipping,
                                 std::vector<Vector2> tangent, std::vector<double> curvature) {
    slipping_ = slipping;
    tangent_ = std::move(tangent);
    curvature_ = std::move(curvature);
    // Points held by a large curvature hardly move: the scaling tells the preconditioner so.
    for (std::size_t k = 0; k < areas_.size(); ++k)
        scaling_[k] = slipping_[k] ? std::sqrt(local_ / (local_ + curvature_[k])) : 1;

    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        for (std::size_t k = 0; k < areas_.size(); ++k)
            constraint_[d].set(k, tilt_.apply(k, {d == 0 ? 1. : 0., d == 1 ? 1. : 0.}));
        project(constraint_[d]);
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

void TangentialSystem::project(TangentialField& f) const {
    for (std::size_t k = 0; k < areas_.size(); ++k)
        if (slipping_[k]) f.set(k, dot(tangent_[k], f.at(k)) * tangent_[k]);
}

void TangentialSystem::precondition(const TangentialField& r, TangentialField& z) {
    for (std::size_t k = 0; k < areas_.size(); ++k) scaled_.set(k, scaling_[k] * r.at(k));
    products_.precondition(scaled_, z);
    for (std::size_t k = 0; k < areas_.size(); ++k) z.set(k, scaling_[k] * z.at(k));
    project(z);
}

namespace {

/// Of `term(k)` over k < n: four sums side by side, which need not wait for each other.
template <class Term>
double sum_of(std::size_t n, Term term) {
    std::array<double, 4> sums{};
    const std::size_t whole = n - n % 4;
    for (std::size_t k = 0; k < whole; k += 4)
        for (std::size_t j = 0; j < 4; ++j) sums[j] += term(k + j);
    for (std::size_t k = whole; k < n; ++k) sums[0] += term(k);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

double TangentialSystem::inner(const TangentialField& a, const TangentialField& b) const {
    return sum_of(areas_.size(),
                  [&](std::size_t k) { return areas_[k] * (a.x[k] * b.x[k] + a.y[k] * b.y[k]); });
}

Vector2 TangentialSystem::total(const TangentialField& z) const {
    Vector2 sum{};
    for (int d = 0; d < 2; ++d)
        sum[d] = sum_of(areas_.size(), [&](std::size_t k) {
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
    precondition_balanced();
    const double target = std::max(limits.absolute, limits.relative * rms_residual());
    double rho = inner(residual_, z_);
    direction_ = z_;
    while (result_.iterations < limits.iterations && rms_residual() > target && rho > 0) {
        apply();
        move(rho / inner(direction_, h_direction_));
        precondition_balanced();
        const double rho_new = inner(residual_, z_);
        turn(rho_new / rho);
        rho = rho_new;
    }
    return result_;
}

namespace {

void add_scaled(std::vector<double>& to, double factor, const std::vector<double>& from) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += factor * from[k];
}

void add_scaled(TangentialField& to, double factor, const TangentialField& from) {
    add_scaled(to.x, factor, from.x);
    add_scaled(to.y, factor, from.y);
}

void clear(TangentialField& f) {
    std::ranges::fill(f.x, 0.0);
    std::ranges::fill(f.y, 0.0);
}

}  // namespace

void TangentialSystem::start(const TangentialField& r) {
    result_.iterations = 0;
    result_.shift_increment = {};
    residual_ = r;
    for (auto* field : {&result_.z, &result_.a_z, &direction_}) clear(*field);
    project(residual_);
}

void TangentialSystem::move(double step) {
    add_scaled(result_.z, step, direction_);
    add_scaled(result_.a_z, step, a_direction_);
    add_scaled(residual_, -step, h_direction_);
}

void TangentialSystem::turn(double beta) {
    for (std::size_t k = 0; k < areas_.size(); ++k)
        direction_.set(k, z_.at(k) + beta * direction_.at(k));
}

/// A particular solution that carries the force `c`; all that follows leaves the force as it is.
void TangentialSystem::carry(const Vector2& c) {
    const Vector2 lambda = constraint_multiplier(c);
    if (lambda[0] == 0 && lambda[1] == 0) return;
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d]) add_scaled(direction_, lambda[d], preconditioned_[d]);
    apply();
    move(1);
}

/// H d = P A d + D d.
void TangentialSystem::apply() {
    products_.apply_roughly(direction_, a_direction_);
    ++result_.iterations;
    h_direction_ = a_direction_;
    project(h_direction_);
    for (std::size_t k = 0; k < areas_.size(); ++k)
        h_direction_.set(k, h_direction_.at(k) + curvature_[k] * direction_.at(k));
}

/// Gives the rigid shift the part of the residual that it can cancel, so that z is balanced.
void TangentialSystem::precondition_balanced() {
    precondition(residual_, z_);
    const Vector2 lambda = constraint_multiplier(total(z_));
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        add_scaled(residual_, -lambda[d], constraint_[d]);
        add_scaled(z_, -lambda[d], preconditioned_[d]);
        result_.shift_increment[d] -= lambda[d];
    }
}

}  // namespace tricontact::contact
