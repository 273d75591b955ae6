#include "contact/compliances/focused_compliance.h"

#include <algorithm>

#include "contact/compliances/dense_products.h"
#include "contact/compliances/point_runs.h"

namespace tricontact::contact {

void FocusedCompliance::focus(std::vector<std::size_t> points) {
    is_focused_ = !points.empty();
    if (points == some_) return;
    some_ = std::move(points);
    const std::size_t n = this->points().size(), m = some_.size();
    const double* const matrix = all_.dense();
    normal_.resize(m * m);
    coupled_.resize(2 * m * m);
    const PointRuns runs(some_);
    const auto normal_rows = [&](std::size_t l) {
        return matrix + 3 * n * (l / m * n + some_[l % m]) + 2 * n;
    };
    for (std::size_t l = 0; l < 3 * m; ++l) {
        if (l + 2 < 3 * m) runs.prefetch(normal_rows(l + 2));
        runs.gather(normal_rows(l), l < 2 * m ? &coupled_[m * l] : &normal_[m * (l - 2 * m)]);
    }
    force_.resize(2 * m);
    displacement_.resize(2 * m);
}

void FocusedCompliance::gather_forces(std::span<const double> traction, std::size_t first) const {
    for (std::size_t k = 0; k < some_.size(); ++k)
        force_[first + k] = traction[some_[k]] * points().area[some_[k]];
}

void FocusedCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    if (!is_focused()) return all_.normal(p, u_z);
    const std::size_t m = some_.size();
    gather_forces(p, 0);
    const auto u = std::span(displacement_).first(m);
    multiply_symmetric({normal_.data(), m}, std::span(force_).first(m), u);
    std::ranges::fill(u_z, 0.0);
    for (std::size_t k = 0; k < m; ++k) u_z[some_[k]] = u[k];
}

void FocusedCompliance::tangential_from_normal(std::span<const double> p,
                                               TangentialField& u) const {
    if (!is_focused()) return all_.tangential_from_normal(p, u);
    const std::size_t m = some_.size();
    gather_forces(p, 0);
    multiply_transposed({coupled_.data(), m}, std::span(force_).first(m), displacement_);
    u = TangentialField(points().size());
    for (std::size_t k = 0; k < m; ++k) u.set(some_[k], {displacement_[k], displacement_[m + k]});
}

void FocusedCompliance::normal_from_tangential(const TangentialField& t,
                                               std::span<double> u_z) const {
    if (!is_focused()) return all_.normal_from_tangential(t, u_z);
    const std::size_t m = some_.size();
    gather_forces(t.x, 0);
    gather_forces(t.y, m);
    const auto u = std::span(displacement_).first(m);
    std::ranges::fill(u, 0.0);
    add_columns({coupled_.data(), m}, force_, u);
    std::ranges::fill(u_z, 0.0);
    for (std::size_t k = 0; k < m; ++k) u_z[some_[k]] = u[k];
}

}  // namespace tricontact::contact
