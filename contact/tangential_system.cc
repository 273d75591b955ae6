#include "contact/tangential_system.h"

#include <algorithm>
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
      scaled_(compliance.points().size()),
      full_(compliance.points().size()),
      force_controlled_(force_controlled) {
    const double self_compliance = compliance.local_tangential();
    // Points held by a large curvature hardly move: the scaling tells the preconditioner so.
    for (std::size_t k = 0; k < active_.size(); ++k)
        scaling_[k] =
            slipping_[k] ? std::sqrt(self_compliance / (self_compliance + curvature_[k])) : 1;
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

void TangentialSystem::precondition(const TangentialField& r, TangentialField& z) const {
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        scaled_.x[i] = scaling_[k] * r.x[i];
        scaled_.y[i] = scaling_[k] * r.y[i];
    }
    compliance_.precondition_tangential(scaled_, full_);
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        z.x[i] = scaling_[k] * full_.x[i];
        z.y[i] = scaling_[k] * full_.y[i];
    }
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

/// Projected, preconditioned conjugate gradients: z keeps the total force that it starts with.
class TangentialSystem::ConjugateGradients {
  public:
    ConjugateGradients(const TangentialSystem& system, const TangentialField& right_hand_side)
        : system_(system),
          n_(right_hand_side.size()),
          result_{TangentialField(n_), TangentialField(n_)},
          residual_(n_),
          direction_(n_),
          a_direction_(n_),
          h_direction_(n_),
          z_(n_) {
        for (const std::size_t i : system.active_) {
            residual_.x[i] = right_hand_side.x[i];
            residual_.y[i] = right_hand_side.y[i];
            area_ += system.compliance_.points().area[i];
        }
        system.project(residual_);
    }

    /// A particular solution that carries the force `c`.
    void carry(const Vector2& c) {
        const Vector2 lambda = system_.constraint_multiplier(c);
        if (lambda[0] == 0 && lambda[1] == 0) return;
        for (int d = 0; d < 2; ++d)
            if (system_.force_controlled_[d])
                add(direction_, lambda[d], system_.preconditioned_[d]);
        apply();
        move(1);
    }

    Result iterate(const Limits& limits) {
        precondition();
        const double target = std::max(limits.absolute, limits.relative * rms_residual());
        double rho = system_.inner(residual_, z_);
        direction_ = z_;
        while (result_.iterations < limits.iterations && rms_residual() > target && rho > 0) {
            apply();
            move(rho / system_.inner(direction_, h_direction_));
            precondition();
            const double rho_new = system_.inner(residual_, z_);
            turn(rho_new / rho);
            rho = rho_new;
        }
        result_.solved = true;
        return std::move(result_);
    }

  private:
    void add(TangentialField& to, double factor, const TangentialField& from) const {
        for (const std::size_t i : system_.active_) {
            to.x[i] += factor * from.x[i];
            to.y[i] += factor * from.y[i];
        }
    }

    /// H d = P A d + D d.
    void apply() {
        system_.compliance_.tangential(direction_, a_direction_);
        ++result_.iterations;
        for (const std::size_t i : system_.active_) {
            h_direction_.x[i] = a_direction_.x[i];
            h_direction_.y[i] = a_direction_.y[i];
        }
        system_.project(h_direction_);
        for (std::size_t k = 0; k < system_.active_.size(); ++k) {
            const std::size_t i = system_.active_[k];
            h_direction_.x[i] += system_.curvature_[k] * direction_.x[i];
            h_direction_.y[i] += system_.curvature_[k] * direction_.y[i];
        }
    }

    void move(double step) {
        add(result_.z, step, direction_);
        add(result_.a_z, step, a_direction_);
        add(residual_, -step, h_direction_);
    }

    void turn(double beta) {
        for (const std::size_t i : system_.active_) {
            direction_.x[i] = z_.x[i] + beta * direction_.x[i];
            direction_.y[i] = z_.y[i] + beta * direction_.y[i];
        }
    }

    /// Gives the rigid shift the part of the residual that it can cancel, so that z is balanced.
    void precondition() {
        system_.precondition(residual_, z_);
        const Vector2 lambda = system_.constraint_multiplier(system_.total(z_));
        for (int d = 0; d < 2; ++d) {
            if (!system_.force_controlled_[d]) continue;
            add(residual_, -lambda[d], system_.constraint_[d]);
            add(z_, -lambda[d], system_.preconditioned_[d]);
            result_.shift_increment[d] -= lambda[d];
        }
    }

    double rms_residual() const { return std::sqrt(system_.inner(residual_, residual_) / area_); }

    const TangentialSystem& system_;
    const std::size_t n_;
    Result result_;
    TangentialField residual_, direction_, a_direction_, h_direction_, z_;
    double area_ = 0;
};

TangentialSystem::Result TangentialSystem::solve(const TangentialField& right_hand_side,
                                                 const Vector2& c, const Limits& limits) const {
    if (!regular_) return {};
    ConjugateGradients iteration(*this, right_hand_side);
    iteration.carry(c);
    return iteration.iterate(limits);
}

}  // namespace tricontact::contact
