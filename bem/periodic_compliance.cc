#include "bem/periodic_compliance.h"

#include <algorithm>

#include "bem/grid_compliance.h"

namespace tricontact::bem {

PeriodicCompliance::PeriodicCompliance(const theory::LayerStack& stack, contact::ContactPoints grid,
                                       int n_threads)
    : PeriodicCompliance(PeriodicInfluence(stack, grid.spacing[0], grid.n_x, n_threads), grid, true,
                         n_threads) {}

PeriodicCompliance::PeriodicCompliance(const contact::MaterialPair& half_spaces,
                                       contact::ContactPoints grid, int n_threads)
    : PeriodicCompliance(PeriodicInfluence(half_spaces, grid.spacing[0], grid.n_x, n_threads), grid,
                         bem::is_coupled(half_spaces), n_threads) {}

PeriodicCompliance::PeriodicCompliance(const PeriodicInfluence& influence,
                                       contact::ContactPoints grid, bool coupled, int n_threads)
    : grid_(std::move(grid)),
      coupled_(coupled),
      convolution_(grid_.n_x, grid_.n_y, grid_.n_x, grid_.n_y, n_threads) {
    grid_.periodic = true;
    const auto symbol = [&](double PeriodicCoefficients::*which) {
        return convolution_.symbol_of_coefficients(
            [&](int m_x, int m_y) { return influence.at(m_x, m_y).*which; });
    };
    using K = PeriodicCoefficients;
    normal_ = symbol(&K::zz);
    tangential_ = {symbol(&K::xx), symbol(&K::xy), symbol(&K::yy)};
    if (coupled_) from_normal_ = {symbol(&K::xz), symbol(&K::yz)};
    inverse_ = inverse(tangential_);
    if (inverse_.xx[0] == 0)  // of half-spaces the mean's: any positive one will do
        inverse_.xx[0] = inverse_.yy[0] = std::min(inverse_.xx[1], inverse_.yy[1]);

    contact::TangentialField one(grid_.size()), u(grid_.size());
    one.x[0] = 1;
    convolution_.apply(tangential_, one.x, one.y, u.x, u.y);
    local_tangential_ = u.x[0];
}

InfluenceTable PeriodicCompliance::influence() const {
    const std::size_t n = grid_.size();
    std::vector<double> one(n), zz(n);
    contact::TangentialField along(n), across(n), by_x(n), by_y(n), by_z(n);
    one[0] = along.x[0] = across.y[0] = 1;
    normal(one, zz);
    tangential(along, by_x);
    tangential(across, by_y);
    tangential_from_normal(one, by_z);
    InfluenceTable table{grid_.spacing[0], grid_.n_x, grid_.n_y, {}};
    for (std::size_t i = 0; i < n; ++i)
        table.cells.push_back({.xx = by_x.x[i],
                               .xy = by_y.x[i],
                               .yy = by_y.y[i],
                               .xz = by_z.x[i],
                               .yz = by_z.y[i],
                               .zx = -by_z.x[i],
                               .zy = -by_z.y[i],
                               .zz = zz[i]});
    return table;
}

void PeriodicCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    convolution_.apply(normal_, p, u_z);
}

void PeriodicCompliance::tangential(const contact::TangentialField& t,
                                    contact::TangentialField& u) const {
    convolution_.apply(tangential_, t.x, t.y, u.x, u.y);
}

void PeriodicCompliance::tangential_from_normal(std::span<const double> p,
                                                contact::TangentialField& u) const {
    if (!coupled_) return Compliance::tangential_from_normal(p, u);
    convolution_.apply(from_normal_, p, u.x, u.y);
}

void PeriodicCompliance::normal_from_tangential(const contact::TangentialField& t,
                                                std::span<double> u_z) const {
    if (!coupled_) return Compliance::normal_from_tangential(t, u_z);
    convolution_.apply_adjoint(from_normal_, t.x, t.y, u_z);
}

void PeriodicCompliance::precondition_tangential(const contact::TangentialField& r,
                                                 contact::TangentialField& z) const {
    convolution_.apply(inverse_, r.x, r.y, z.x, z.y);
}

}  // namespace tricontact::bem
