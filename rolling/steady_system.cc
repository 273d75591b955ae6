#include <algorithm>
#include <utility>

#include "rolling/gmres.h"
#include "rolling/steady_solver.h"
#include "rolling/stick_inverse.h"

namespace tricontact::rolling {

namespace {

using contact::operator+, contact::operator-, contact::operator*, contact::operator/;
using Eigen::VectorXd;

constexpr int max_iterations = 400;

/// x components of the active points, then their y components.
VectorXd gathered(const contact::TangentialField& f, const std::vector<std::size_t>& active) {
    VectorXd v(2 * active.size());
    v << VectorXd::Map(f.x.data(), f.size())(active), VectorXd::Map(f.y.data(), f.size())(active);
    return v;
}

/// The same back on the points, 0 elsewhere.
contact::TangentialField scattered(const VectorXd& v, const std::vector<std::size_t>& active,
                                   std::size_t n_points) {
    contact::TangentialField f(n_points);
    VectorXd::Map(f.x.data(), n_points)(active) = v.head(active.size());
    VectorXd::Map(f.y.data(), n_points)(active) = v.segment(active.size(), active.size());
    return f;
}

}  // namespace

contact::TangentialField forward_gradient(const contact::ContactPoints& grid,
                                          const std::vector<std::size_t>& active,
                                          const contact::TangentialField& u) {
    contact::TangentialField gradient(u.size());
    for (const std::size_t i : active) gradient.set(i, (u.at(i + 1) - u.at(i)) / grid.spacing[0]);
    return gradient;
}

SteadySystem::SteadySystem(const contact::Compliance& compliance,
                           const std::vector<std::size_t>& active,
                           std::array<bool, 2> force_controlled, const StickInverse& stick_inverse)
    : compliance_(compliance),
      stick_inverse_(stick_inverse),
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
    sticks_.assign(compliance_.points().size(), 0);
    for (Eigen::Index k = 0; k < m; ++k) sticks_[active_[k]] = !slipping_[k];
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        VectorXd along = VectorXd::Zero(2 * m);
        along.segment(d * m, m).setOnes();
        answer_[d] = without_balance(projected(along));
    }
    relief_ = relief;
    for (int d = 0; d < 2; ++d) {
        if (!force_controlled_[d]) continue;
        for (int e = 0; e < 2; ++e) force(d, e) = force_controlled_[e] ? total(answer_[e])[d] : 0;
        force(d, d) += relief_;
    }
    force_inverse_ = force.inverse();
}

/// Of two components per active point those along which tractions may change.
VectorXd SteadySystem::projected(const VectorXd& f) const {
    const Eigen::Index m = active_.size();
    VectorXd p = f.head(2 * m);
    for (Eigen::Index k = 0; k < m; ++k) {
        if (!slipping_[k]) continue;
        const double along = tangent_[k][0] * f[k] + tangent_[k][1] * f[m + k];
        p[k] = along * tangent_[k][0];
        p[m + k] = along * tangent_[k][1];
    }
    return p;
}

/// What of z displaces: without slipping points' tractions that their bounds hold.
VectorXd SteadySystem::admissible(const VectorXd& z) const {
    return following_.own.empty() ? projected(z) : VectorXd(z.head(2 * active_.size()));
}

/// Of the bounds [Pa] per active point, by this change of the slip [-].
VectorXd SteadySystem::bound_change(const VectorXd& slip_change) const {
    const Eigen::Index m = active_.size();
    VectorXd change = VectorXd::Zero(m);
    for (Eigen::Index k = m - 1; k >= 0; --k) {
        if (slipping_[k]) {
            const contact::Vector2 e = direction(k);
            change[k] = following_.own[k] * (e[0] * slip_change[k] + e[1] * slip_change[m + k]);
        }
        if (following_.ahead[k] != 0) change[k] += following_.ahead[k] * change[k + 1];
    }
    return change;
}

/// M z.
VectorXd SteadySystem::sliding(const VectorXd& z) const {
    const contact::ContactPoints& points = compliance_.points();
    contact::TangentialField u(points.size());
    compliance_.tangential(scattered(z, active_, points.size()), u);
    return -gathered(forward_gradient(points, active_, u), active_);
}

/// Creepage that the total force of z would be on cells by themselves [-]: what makes the force
/// balance comparable with the other equations.
Eigen::Vector2d SteadySystem::total(const VectorXd& z) const {
    const Eigen::Index m = active_.size();
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    for (Eigen::Index k = 0; k < m; ++k)
        force += compliance_.points().area[active_[k]] * Eigen::Vector2d(z[k], z[m + k]);
    return force * (local_ / area_);
}

VectorXd SteadySystem::product(const VectorXd& z) const {
    const Eigen::Index m = active_.size();
    const VectorXd held = projected(z);
    const bool follows = !following_.own.empty();
    const VectorXd all_of_it = follows ? VectorXd(z.head(2 * m)) : VectorXd();
    const VectorXd& moved = follows ? all_of_it : held;
    VectorXd r = sliding(moved);
    for (int d = 0; d < 2; ++d) r.segment(d * m, m).array() -= z[2 * m + d];
    VectorXd all(size());
    all.head(2 * m) = projected(r);
    // Directions that are held have equations of their own: they stay at zero, or follow the slip.
    for (Eigen::Index k = 0; k < 2 * m; ++k)
        all[k] += curvature_[k % m] * z[k] + local_ * (z[k] - held[k]);
    if (follows) {
        const VectorXd change = bound_change(-r);
        for (Eigen::Index k = 0; k < m; ++k) {
            if (!slipping_[k]) continue;
            const contact::Vector2 e = direction(k);
            const double along = e[0] * z[k] + e[1] * z[m + k];
            const double extra = -local_ * change[k] - curvature_[k] * along;
            all[k] += extra * e[0];
            all[m + k] += extra * e[1];
        }
    }
    const Eigen::Vector2d force = total(moved);
    for (int d = 0; d < 2; ++d)
        all[2 * m + d] = force_controlled_[d] ? force[d] + relief_ * z[2 * m + d] : z[2 * m + d];
    return all;
}

/// An approximate inverse but for the force balance: of points that stick among themselves, and
/// of those that slip each by itself.
VectorXd SteadySystem::without_balance(const VectorXd& r) const {
    const Eigen::Index m = active_.size();
    VectorXd z(2 * m);
    contact::TangentialField f(sticks_.size());
    for (Eigen::Index k = 0; k < m; ++k) {
        if (!slipping_[k]) f.set(active_[k], {r[k], r[m + k]});
        const double alone = local_ + curvature_[k];
        z[k] = r[k] / alone;
        z[m + k] = r[m + k] / alone;
    }
    stick_inverse_.apply(sticks_, f);
    for (Eigen::Index k = 0; k < m; ++k) {
        if (slipping_[k]) continue;
        z[k] = f.x[active_[k]];
        z[m + k] = f.y[active_[k]];
    }
    return z;
}

VectorXd SteadySystem::preconditioned(const VectorXd& r) const {
    const Eigen::Index m = active_.size();
    VectorXd z(size());
    z.head(2 * m) = without_balance(r);
    const Eigen::Vector2d force = total(admissible(z));
    Eigen::Vector2d missing = r.tail(2);
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d]) missing[d] -= force[d];
    z.tail(2) = force_inverse_ * missing;
    for (int d = 0; d < 2; ++d)
        if (force_controlled_[d]) z.head(2 * m) += z[2 * m + d] * answer_[d];
    return z;
}

/// Of bounds that follow, along slipping points' tractions.
void SteadySystem::add_missing(VectorXd& right_hand_side) const {
    if (following_.own.empty()) return;
    const Eigen::Index m = active_.size();
    for (Eigen::Index k = 0; k < m; ++k) {
        if (!slipping_[k]) continue;
        const contact::Vector2 e = direction(k);
        right_hand_side[k] += local_ * following_.missing[k] * e[0];
        right_hand_side[m + k] += local_ * following_.missing[k] * e[1];
    }
}

SteadySystem::Result SteadySystem::solve(const contact::TangentialField& r,
                                         const contact::Vector2& c, double tolerance) const {
    const Eigen::Index m = active_.size();
    VectorXd right_hand_side(size());
    right_hand_side.head(2 * m) = projected(gathered(r, active_));
    add_missing(right_hand_side);
    for (int d = 0; d < 2; ++d)
        right_hand_side[2 * m + d] = force_controlled_[d] ? c[d] * local_ / area_ : 0;

    const GmresResult found = gmres([&](const VectorXd& x) { return product(x); },
                                    [&](const VectorXd& x) { return preconditioned(x); },
                                    right_hand_side, tolerance, max_iterations);
    Result result{scattered(admissible(found.x), active_, compliance_.points().size()),
                  {},
                  found.iterations,
                  found.residual};
    for (int d = 0; d < 2; ++d) result.creepage[d] = force_controlled_[d] ? found.x[2 * m + d] : 0;
    return result;
}

}  // namespace tricontact::rolling
