#include <algorithm>
#include <utility>

#include "rolling/gmres.h"
#include "rolling/steady_solver.h"

namespace tricontact::rolling {

namespace {

constexpr int max_iterations = 400;

}  // namespace

contact::TangentialField forward_gradient(const contact::ContactPoints& grid,
                                          const std::vector<std::size_t>& active,
                                          const contact::TangentialField& u) {
    contact::TangentialField gradient(u.size());
    for (const std::size_t i : active) {
        gradient.x[i] = (u.x[i + 1] - u.x[i]) / grid.spacing[0];
        gradient.y[i] = (u.y[i + 1] - u.y[i]) / grid.spacing[0];
    }
    return gradient;
}

SteadySystem::SteadySystem(const contact::Compliance& compliance,
                           const std::vector<std::size_t>& active,
                           std::array<bool, 2> force_controlled)
    : compliance_(compliance),
      active_(active),
      force_controlled_(force_controlled),
      local_(compliance.local_tangential() / compliance.points().spacing[0]) {
    for (const std::size_t i : active_) area_ += compliance.points().area[i];
}

void SteadySystem::set_zones(std::vector<std::uint8_t> slipping,
                             std::vector<contact::Vector2> tangent, std::vector<double> curvature,
                             double relief) {
    slipping_ = std::move(slipping);
    tangent_ = std::move(tangent);
    curvature_ = std::move(curvature);
    const Eigen::Index m = active_.size();
    Eigen::Matrix2d force = Eigen::Matrix2d::Identity();
    all_stick_ = std::count(slipping_.begin(), slipping_.end(), 0) == m;
    for (int d = 0; d < 2; ++d) {
        Eigen::VectorXd along = Eigen::VectorXd::Zero(2 * m);
        along.segment(d * m, m).setOnes();
        answer_[d] = without_balance(projected(along));
    }
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        for (int e = 0; e < 2; ++e) force(d, e) = force_controlled_[e] ? total(answer_[e])[d] : 0;
    }
    relief_ = relief;
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d]) force(d, d) += relief_;
    force_inverse_ = force.inverse();
}

/// Of two components per active point those along which tractions may change.
Eigen::VectorXd SteadySystem::projected(const Eigen::VectorXd& f) const {
    const Eigen::Index m = active_.size();
    Eigen::VectorXd p = f.head(2 * m);
    for (Eigen::Index k = 0; k < m; ++k) {
        if (!slipping_[k]) continue;
        const double along = tangent_[k][0] * f[k] + tangent_[k][1] * f[m + k];
        p[k] = along * tangent_[k][0];
        p[m + k] = along * tangent_[k][1];
    }
    return p;
}

/// M z.
Eigen::VectorXd SteadySystem::sliding(const Eigen::VectorXd& z) const {
    const Eigen::Index m = active_.size();
    contact::TangentialField t(compliance_.points().size()), u(t.size());
    for (Eigen::Index k = 0; k < m; ++k) {
        t.x[active_[k]] = z[k];
        t.y[active_[k]] = z[m + k];
    }
    compliance_.tangential(t, u);
    const contact::TangentialField gradient = forward_gradient(compliance_.points(), active_, u);
    Eigen::VectorXd s(2 * m);
    for (Eigen::Index k = 0; k < m; ++k) {
        s[k] = -gradient.x[active_[k]];
        s[m + k] = -gradient.y[active_[k]];
    }
    return s;
}

/// Creepage that the total force of z would be on cells by themselves [-]: what makes the force
/// balance comparable with the other equations.
Eigen::Vector2d SteadySystem::total(const Eigen::VectorXd& z) const {
    const Eigen::Index m = active_.size();
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    for (Eigen::Index k = 0; k < m; ++k)
        force += compliance_.points().area[active_[k]] * Eigen::Vector2d(z[k], z[m + k]);
    return force * (local_ / area_);
}

Eigen::VectorXd SteadySystem::product(const Eigen::VectorXd& z) const {
    const Eigen::Index m = active_.size();
    const Eigen::VectorXd admissible = projected(z);
    Eigen::VectorXd r = sliding(admissible);
    for (int d = 0; d < 2; ++d) r.segment(d * m, m).array() -= z[2 * m + d];
    Eigen::VectorXd all(size());
    all.head(2 * m) = projected(r);
    // Directions that are held have equations of their own: they stay at zero.
    for (Eigen::Index k = 0; k < 2 * m; ++k)
        all[k] += curvature_[k % m] * z[k] + local_ * (z[k] - admissible[k]);
    const Eigen::Vector2d force = total(admissible);
    for (int d = 0; d < 2; ++d)
        all[2 * m + d] = force_controlled_[d] ? force[d] + relief_ * z[2 * m + d] : z[2 * m + d];
    return all;
}

/// The inverse of M by what it is made of: displacements by summing slip up from the leading edge,
/// as if nothing moved ahead of it, and tractions from those.
Eigen::VectorXd SteadySystem::unrolled(const Eigen::VectorXd& r) const {
    const Eigen::Index m = active_.size();
    const contact::ContactPoints& points = compliance_.points();
    contact::TangentialField u(points.size()), t(points.size());
    for (Eigen::Index k = m - 1; k >= 0; --k) {
        const std::size_t i = active_[k];
        u.x[i] = u.x[i + 1] + points.spacing[0] * r[k];
        u.y[i] = u.y[i + 1] + points.spacing[0] * r[m + k];
    }
    compliance_.precondition_tangential(u, t);
    Eigen::VectorXd z(2 * m);
    for (Eigen::Index k = 0; k < m; ++k) {
        z[k] = t.x[active_[k]];
        z[m + k] = t.y[active_[k]];
    }
    return z;
}

/// An approximate inverse but for the force balance. Once points slip, cells by themselves need
/// fewer iterations.
Eigen::VectorXd SteadySystem::without_balance(const Eigen::VectorXd& r) const {
    if (all_stick_) return unrolled(r);
    const Eigen::Index m = active_.size();
    Eigen::VectorXd z(2 * m);
    for (Eigen::Index k = 0; k < 2 * m; ++k) z[k] = r[k] / (local_ + curvature_[k % m]);
    return z;
}

Eigen::VectorXd SteadySystem::preconditioned(const Eigen::VectorXd& r) const {
    const Eigen::Index m = active_.size();
    Eigen::VectorXd z(size());
    z.head(2 * m) = without_balance(r);
    const Eigen::Vector2d force = total(projected(z));
    Eigen::Vector2d missing = r.tail(2);
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d]) missing[d] -= force[d];
    z.tail(2) = force_inverse_ * missing;
    for (int d = 0; d < 2; ++d) z.head(2 * m) += z[2 * m + d] * answer_[d];
    return z;
}

SteadySystem::Result SteadySystem::solve(const contact::TangentialField& r,
                                         const contact::Vector2& c, double tolerance) const {
    const Eigen::Index m = active_.size();
    Eigen::VectorXd right_hand_side(size());
    for (Eigen::Index k = 0; k < m; ++k) {
        right_hand_side[k] = r.x[active_[k]];
        right_hand_side[m + k] = r.y[active_[k]];
    }
    right_hand_side.head(2 * m) = projected(right_hand_side);
    for (int d = 0; d < 2; ++d)
        right_hand_side[2 * m + d] = force_controlled_[d] ? c[d] * local_ / area_ : 0;

    const GmresResult found = gmres([&](const Eigen::VectorXd& x) { return product(x); },
                                    [&](const Eigen::VectorXd& x) { return preconditioned(x); },
                                    right_hand_side, tolerance, max_iterations);
    const Eigen::VectorXd& solution = found.x;
    const Eigen::VectorXd z = projected(solution);
    Result result{contact::TangentialField(compliance_.points().size()),
                  {},
                  found.iterations,
                  found.residual};
    for (Eigen::Index k = 0; k < m; ++k) {
        result.z.x[active_[k]] = z[k];
        result.z.y[active_[k]] = z[m + k];
    }
    for (int d = 0; d < 2; ++d) result.creepage[d] = force_controlled_[d] ? solution[2 * m + d] : 0;
    return result;
}

}  // namespace tricontact::rolling
