#include "bem/periodic_compliance.h"

namespace tricontact::bem {

PeriodicCompliance::PeriodicCompliance(const theory::LayerStack& stack, contact::ContactPoints grid,
                                       int n_threads)
    : grid_(std::move(grid)), convolution_(grid_.n_x, grid_.n_y, grid_.n_x, grid_.n_y, n_threads) {
    const PeriodicInfluence influence(stack, grid_.spacing[0], grid_.n_x, n_threads);
    const auto symbol = [&](double PeriodicCoefficients::*which) {
        return convolution_.symbol_of_coefficients(
            [&](int m_x, int m_y) { return influence.at(m_x, m_y).*which; });
    };
    using K = PeriodicCoefficients;
    normal_ = symbol(&K::zz);
    tangential_ = {symbol(&K::xx), symbol(&K::xy), symbol(&K::yy)};
    from_normal_ = {symbol(&K::xz), symbol(&K::yz)};
    inverse_ = inverse(tangential_);

    contact::TangentialField one(grid_.size()), u(grid_.size());
    one.x[0] = 1;
    convolution_.apply(tangential_, one.x, one.y, u.x, u.y);
    local_tangential_ = u.x[0];
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
    convolution_.apply(from_normal_, p, u.x, u.y);
}

void PeriodicCompliance::normal_from_tangential(const contact::TangentialField& t,
                                                std::span<double> u_z) const {
    convolution_.apply_adjoint(from_normal_, t.x, t.y, u_z);
}

void PeriodicCompliance::precondition_tangential(const contact::TangentialField& r,
                                                 contact::TangentialField& z) const {
    convolution_.apply(inverse_, r.x, r.y, z.x, z.y);
}

}  // namespace tricontact::bem
