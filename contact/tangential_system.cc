#include "contact/tangential_system.h"

#include <cmath>
#include <utility>

namespace tricontact::contact {

TangentialSystem::TangentialSystem(const Compliance& compliance,
                                   const std::vector<std::size_t>& active,
                                   std::vector<std::uint8_t> slipping, std::vector<Vector2> tangent,
                                   std::vector<double> curvature,
                                   std::array<bool, 2> force_controlled)
    : compliance_(compliance),
      active_(active),
      slipping_(std::move(slipping)),
      tangent_(std::move(tangent)),
      curvature_(std::move(curvature)),
      scaling_(active.size()),
      force_controlled_(force_controlled) {
    const double self_compliance = compliance.local_tangential();
    // Points held by a large curvature hardly move: the scaling tells the preconditioner so.
    for (std::size_t k = 0; k < active_.size(); ++k)
        scaling_[k] = slipping_[k] ? std::sqrt(self_compliance / (self_compliance + curvature_[k])) : 1;
    regular_ = prepare_constraint();
}

void TangentialSystem::project(TangentialField& f) const {
    for (std::size_t k = 0; k < active_.size(); ++k) {
        if (!slipping_[k]) continue;
        const std::size_t i = active_[k];
        const double along = tangent_[k][0] * f.x[i] + tangent_[k][1] * f.y[i];
        f.x[i] = along * tangent_[k][0];
        f.y[i] = along * tangent_[k][1];
    }
}

void TangentialSystem::scale(TangentialField& f) const {
    for (std::size_t k = 0; k < active_.size(); ++k) {
        f.x[active_[k]] *= scaling_[k];
        f.y[active_[k]] *= scaling_[k];
    }
}

void TangentialSystem::precondition(const TangentialField& r, TangentialField& z) const {
    TangentialField scaled(r.size());
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        scaled.x[i] = scaling_[k] * r.x[i];
        scaled.y[i] = scaling_[k] * r.y[i];
    }
    TangentialField full(r.size());
    compliance_.precondition_tangential(scaled, full);
    for (const std::size_t i : active_) {
        z.x[i] = full.x[i];
        z.y[i] = full.y[i];
    }
    scale(z);
    project(z);
}

double TangentialSystem::inner(const TangentialField& a, const TangentialField& b) const {
    const auto& area = compliance_.points().area;
    double sum = 0;
    for (const std::size_t i : active_) sum += area[i] * (a.x[i] * b.x[i] + a.y[i] * b.y[i]);
    return sum;
}

Vector2 TangentialSystem::total(const TangentialField& z) const {
    const auto& area = compliance_.points().area;
    Vector2 sum{};
    for (const std::size_t i : active_) {
        sum[0] += area[i] * z.x[i];
        sum[1] += area[i] * z.y[i];
    }
    return sum;
}

bool TangentialSystem::prepare_constraint() {
    const std::size_t n = compliance_.points().size();
    std::array<std::array<double, 2>, 2> schur{{{1, 0}, {0, 1}}};
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        constraint_[d] = TangentialField(n);
        preconditioned_[d] = TangentialField(n);
        for (const std::size_t i : active_) (d == 0 ? constraint_[d].x : constraint_[d].y)[i] = 1;
        project(constraint_[d]);
        precondition(constraint_[d], preconditioned_[d]);
    }
    for (int d = 0; d < 2; ++d)
        for (int e = 0; e < 2; ++e)
            if (force_controlled_[d] && force_controlled_[e])
                schur[d][e] = inner(constraint_[d], preconditioned_[e]);
    const double determinant = schur[0][0] * schur[1][1] - schur[0][1] * schur[1][0];
    schur_inverse_ = {{{schur[1][1] / determinant, -schur[0][1] / determinant},
                       {-schur[1][0] / determinant, schur[0][0] / determinant}}};
    return determinant > 1e-10 * schur[0][0] * schur[1][1];
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

TangentialSystem::Result TangentialSystem::solve(const TangentialField& right_hand_side,
                                                 const Vector2& c, const Limits& limits) const {
    const std::size_t n = right_hand_side.size();
    Result result{TangentialField(n), TangentialField(n)};
    if (!regular_) return result;
    result.solved = true;

    TangentialField residual(n), direction(n), a_direction(n), h_direction(n), z(n);
    for (const std::size_t i : active_) {
        residual.x[i] = right_hand_side.x[i];
        residual.y[i] = right_hand_side.y[i];
    }
    project(residual);

    auto add = [this](TangentialField& to, double factor, const TangentialField& from) {
        for (const std::size_t i : active_) {
            to.x[i] += factor * from.x[i];
            to.y[i] += factor * from.y[i];
        }
    };
    auto apply = [&](const TangentialField& from) {
        compliance_.tangential(from, a_direction);
        ++result.iterations;
        for (const std::size_t i : active_) {
            h_direction.x[i] = a_direction.x[i];
            h_direction.y[i] = a_direction.y[i];
        }
        project(h_direction);
        for (std::size_t k = 0; k < active_.size(); ++k) {
            h_direction.x[active_[k]] += curvature_[k] * from.x[active_[k]];
            h_direction.y[active_[k]] += curvature_[k] * from.y[active_[k]];
        }
    };
    auto move_along = [&](double step) {
        add(result.z, step, direction);
        add(residual, -step, h_direction);
        for (std::size_t i = 0; i < n; ++i) {
            result.a_z.x[i] += step * a_direction.x[i];
            result.a_z.y[i] += step * a_direction.y[i];
        }
    };
    // Takes the part of the residual that the rigid shift can cancel, so that z keeps the forces.
    auto precondition_balanced = [&] {
        precondition(residual, z);
        const Vector2 lambda = constraint_multiplier(total(z));
        for (int d = 0; d < 2; ++d) {
            if (!force_controlled_[d]) continue;
            add(residual, -lambda[d], constraint_[d]);
            add(z, -lambda[d], preconditioned_[d]);
            result.shift_increment[d] -= lambda[d];
        }
    };

    // A particular solution carries the missing force.
    const Vector2 lambda = constraint_multiplier(c);
    if (lambda[0] != 0 || lambda[1] != 0) {
        for (int d = 0; d < 2; ++d)
            if (force_controlled_[d]) add(direction, lambda[d], preconditioned_[d]);
        apply(direction);
        move_along(1);
    }

    double area = 0;
    for (const std::size_t i : active_) area += compliance_.points().area[i];
    auto rms = [&] { return std::sqrt(inner(residual, residual) / area); };

    precondition_balanced();
    const double target = std::max(limits.absolute, limits.relative * rms());
    double rho = inner(residual, z);
    direction = z;
    while (result.iterations < limits.iterations && rms() > target && rho > 0) {
        apply(direction);
        move_along(rho / inner(direction, h_direction));
        precondition_balanced();
        const double rho_new = inner(residual, z);
        const double beta = rho_new / rho;
        rho = rho_new;
        for (const std::size_t i : active_) {
            direction.x[i] = z.x[i] + beta * direction.x[i];
            direction.y[i] = z.y[i] + beta * direction.y[i];
        }
    }
    return result;
}

}  // namespace tricontact::contact
