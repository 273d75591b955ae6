#include "contact/solvers/tangential_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/error.h"

namespace tricontact::contact {

namespace {

class ProductOperator final : public ActiveOperator {
  public:
    explicit ProductOperator(const Compliance& compliance) : compliance_(compliance) {}
    void apply(const TangentialField& t, TangentialField& u) const override {
        compliance_.tangential(t, u);
    }
    bool displaces_all() const override { return true; }
    void precondition(const TangentialField& r, TangentialField& z) const override {
        compliance_.precondition_tangential(r, z);
    }

  private:
    const Compliance& compliance_;
};

/// The matrix of the active points by itself: a fraction of all, and small enough to factorise.
/// Its Cholesky factor is the exact inverse as long as all points stick.
class DenseOperator final : public ActiveOperator {
  public:
    DenseOperator(const Compliance& compliance, const std::vector<std::size_t>& active)
        : active_(active),
          area_(compliance.points().area),
          matrix_(2 * active.size(), 2 * active.size()),
          in_(2 * active.size()),
          out_(2 * active.size()) {
        const std::size_t n = area_.size(), m = active_.size();
        const double* const all = compliance.dense();
        for (std::size_t l = 0; l < 2 * m; ++l) {
            const double* const column = all + 3 * n * (l / m * n + active_[l % m]);
            for (std::size_t k = 0; k < 2 * m; ++k)
                matrix_(k, l) = column[k / m * n + active_[k % m]];
        }
        factorise();
    }

    void apply(const TangentialField& t, TangentialField& u) const override {
        gather(t, true);
        out_.noalias() = matrix_.selfadjointView<Eigen::Lower>() * in_;
        scatter(u);
    }

    bool displaces_all() const override { return false; }

    void precondition(const TangentialField& r, TangentialField& z) const override {
        gather(r, false);
        out_ = factor_.solve(in_);
        const std::size_t m = active_.size();
        for (std::size_t k = 0; k < m; ++k)
            for (std::size_t c = 0; c < 2; ++c) out_[c * m + k] /= area_[active_[k]];
        scatter(z);
    }

  private:
    /// Held components have zero rows: any number on their diagonal keeps them at zero.
    void factorise() {
        Eigen::MatrixXd regular = matrix_;
        const double typical = regular.diagonal().mean();
        for (Eigen::Index k = 0; k < regular.rows(); ++k)
            if (regular(k, k) == 0) regular(k, k) = typical;
        factor_.compute(regular);
        if (factor_.info() != Eigen::Success)
            throw NotConverged("tangential contact: the compliance is not positive definite");
    }

    void gather(const TangentialField& f, bool times_area) const {
        const std::size_t m = active_.size();
        for (std::size_t k = 0; k < m; ++k) {
            const std::size_t i = active_[k];
            const double factor = times_area ? area_[i] : 1;
            in_[k] = factor * f.x[i];
            in_[m + k] = factor * f.y[i];
        }
    }

    void scatter(TangentialField& f) const {
        const std::size_t m = active_.size();
        for (std::size_t k = 0; k < m; ++k) {
            f.x[active_[k]] = out_[k];
            f.y[active_[k]] = out_[m + k];
        }
    }

    const std::vector<std::size_t> active_;
    const std::vector<double>& area_;
    Eigen::MatrixXd matrix_;  // displacement over force
    Eigen::LLT<Eigen::MatrixXd> factor_;
    mutable Eigen::VectorXd in_, out_;
};

}  // namespace

std::unique_ptr<const ActiveOperator> make_active_operator(const Compliance& compliance,
                                                           const std::vector<std::size_t>& active) {
    if (compliance.dense()) return std::make_unique<DenseOperator>(compliance, active);
    return std::make_unique<ProductOperator>(compliance);
}

/// E follows from turning (0, 0, 1) to the normal (-slope, 1)/n: D = 1 - slope slope'/(n (n + 1)).
Tilt::Tilt(const TangentialField& slope) : parts_(slope.size()) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const auto [x, y] = slope.at(i);
        const double n = std::sqrt(1 + x * x + y * y), factor = 1 / (n * (n + 1));
        parts_[i] = {1 - factor * x * x, -factor * x * y, 1 - factor * y * y};
    }
}

TangentialSystem::TangentialSystem(const Compliance& compliance,
                                   const std::vector<std::size_t>& active,
                                   const ActiveOperator& products,
                                   std::array<bool, 2> force_controlled, Tilt tilt)
    : compliance_(compliance),
      active_(active),
      products_(products),
      force_controlled_(force_controlled),
      tilt_(std::move(tilt)),
      scaling_(active.size()) {
    const std::size_t n = compliance.points().size();
    for (const std::size_t i : active_) area_ += compliance.points().area[i];
    for (auto* field : {&constraint_[0], &constraint_[1], &preconditioned_[0], &preconditioned_[1],
                        &result_.z, &result_.a_z, &residual_, &direction_, &a_direction_,
                        &h_direction_, &z_, &scaled_, &full_})
        *field = TangentialField(n);
}

bool TangentialSystem::set_zones(const std::vector<std::uint8_t>& slipping,
                                 std::vector<Vector2> tangent, std::vector<double> curvature) {
    slipping_ = slipping;
    tangent_ = std::move(tangent);
    curvature_ = std::move(curvature);
    // Points held by a large curvature hardly move: the scaling tells the preconditioner so.
    const double local = compliance_.local_tangential();
    for (std::size_t k = 0; k < active_.size(); ++k)
        scaling_[k] = slipping_[k] ? std::sqrt(local / (local + curvature_[k])) : 1;

    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        for (const std::size_t i : active_)
            constraint_[d].set(i, tilt_.apply(i, {d == 0 ? 1. : 0., d == 1 ? 1. : 0.}));
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
    for (std::size_t k = 0; k < active_.size(); ++k) {
        if (!slipping_[k]) continue;
        const std::size_t i = active_[k];
        f.set(i, dot(tangent_[k], f.at(i)) * tangent_[k]);
    }
}

void TangentialSystem::precondition(const TangentialField& r, TangentialField& z) {
    for (std::size_t k = 0; k < active_.size(); ++k)
        scaled_.set(active_[k], scaling_[k] * r.at(active_[k]));
    products_.precondition(scaled_, full_);
    for (std::size_t k = 0; k < active_.size(); ++k)
        z.set(active_[k], scaling_[k] * full_.at(active_[k]));
    project(z);
}

double TangentialSystem::inner(const TangentialField& a, const TangentialField& b) const {
    const auto& area = compliance_.points().area;
    double sum = 0;
    for (const std::size_t i : active_) sum += area[i] * dot(a.at(i), b.at(i));
    return sum;
}

Vector2 TangentialSystem::total(const TangentialField& z) const {
    const auto& area = compliance_.points().area;
    Vector2 sum{};
    for (const std::size_t i : active_) sum = sum + area[i] * tilt_.apply(i, z.at(i));
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

void TangentialSystem::start(const TangentialField& r) {
    result_.iterations = 0;
    result_.shift_increment = {};
    for (const std::size_t i : active_) {
        residual_.set(i, r.at(i));
        for (auto* field : {&result_.z, &result_.a_z, &direction_}) field->set(i, {0, 0});
    }
    project(residual_);
}

/// A particular solution that carries the force `c`; all that follows leaves the force as it is.
void TangentialSystem::carry(const Vector2& c) {
    const Vector2 lambda = constraint_multiplier(c);
    if (lambda[0] == 0 && lambda[1] == 0) return;
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d]) add(direction_, lambda[d], preconditioned_[d]);
    apply();
    move(1);
}

/// H d = P A d + D d.
void TangentialSystem::apply() {
    products_.apply(direction_, a_direction_);
    ++result_.iterations;
    for (const std::size_t i : active_) h_direction_.set(i, a_direction_.at(i));
    project(h_direction_);
    for (std::size_t k = 0; k < active_.size(); ++k) {
        const std::size_t i = active_[k];
        h_direction_.set(i, h_direction_.at(i) + curvature_[k] * direction_.at(i));
    }
}

/// Gives the rigid shift the part of the residual that it can cancel, so that z is balanced.
void TangentialSystem::precondition_balanced() {
    precondition(residual_, z_);
    const Vector2 lambda = constraint_multiplier(total(z_));
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        add(residual_, -lambda[d], constraint_[d]);
        add(z_, -lambda[d], preconditioned_[d]);
        result_.shift_increment[d] -= lambda[d];
    }
}

}  // namespace tricontact::contact
