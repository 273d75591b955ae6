#include "bem/half_space_compliance.h"

#include <cmath>

#include "bem/influence.h"

namespace tricontact::bem {

namespace {

using Symbol2 = GridConvolution::Symbol2;

template <typename Select>
GridConvolution::Symbol symbol_of(const GridConvolution& convolution,
                                  const contact::MaterialPair& materials,
                                  const contact::ContactPoints& grid, Select select) {
    const RectangleInfluence influence(materials, grid.spacing[0], grid.spacing[1]);
    return convolution.symbol([&](int i, int j) {
        return select(influence.at(i * grid.spacing[0], j * grid.spacing[1]));
    });
}

Symbol2 tangential_symbol(const GridConvolution& convolution,
                          const contact::MaterialPair& materials,
                          const contact::ContactPoints& grid) {
    using Influence = InfluenceCoefficients;
    return {symbol_of(convolution, materials, grid, [](const Influence& k) { return k.xx; }),
            symbol_of(convolution, materials, grid, [](const Influence& k) { return k.xy; }),
            symbol_of(convolution, materials, grid, [](const Influence& k) { return k.yy; })};
}

/// Below this many cells a thread costs more than it brings.
constexpr std::size_t cells_worth_threads = 100000;

/// Inverse matrix per wave vector; where a truncated kernel is not positive definite, its diagonal.
Symbol2 inverse(Symbol2 symbol) {
    for (std::size_t k = 0; k < symbol.xx.size(); ++k) {
        double &xx = symbol.xx[k], &xy = symbol.xy[k], &yy = symbol.yy[k];
        if (xx == 0 && yy == 0) continue;  // padding of the spectrum's rows
        if (!(xx > 0 && yy > 0 && xx * yy > xy * xy)) {
            xx = std::abs(xx);
            yy = std::abs(yy);
            xy = 0;
        }
        const double determinant = xx * yy - xy * xy, old_xx = xx;
        xx = yy / determinant;
        yy = old_xx / determinant;
        xy = -xy / determinant;
    }
    return symbol;
}

}  // namespace

HalfSpaceCompliance::HalfSpaceCompliance(const contact::MaterialPair& materials,
                                         contact::ContactPoints grid, int n_threads)
    : materials_(materials),
      grid_(std::move(grid)),
      n_threads_(grid_.size() < cells_worth_threads ? 1 : n_threads),
      linear_(grid_.n_x, grid_.n_y, good_fft_size(2 * grid_.n_x - 1),
              good_fft_size(2 * grid_.n_y - 1), n_threads_),
      periodic_(grid_.n_x, grid_.n_y, good_fft_size(grid_.n_x), good_fft_size(grid_.n_y),
                n_threads_),
      normal_(symbol_of(linear_, materials_, grid_,
                        [](const InfluenceCoefficients& k) { return k.zz; })) {}

void HalfSpaceCompliance::prepare_tangential() const {
    tangential_ = tangential_symbol(linear_, materials_, grid_);
    inverse_ = inverse(tangential_symbol(periodic_, materials_, grid_));
}

void HalfSpaceCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    linear_.apply(normal_, p, u_z);
}

void HalfSpaceCompliance::tangential(const contact::TangentialField& t,
                                     contact::TangentialField& u) const {
    if (!tangential_) prepare_tangential();
    linear_.apply(*tangential_, t.x, t.y, u.x, u.y);
}

double HalfSpaceCompliance::local_tangential() const {
    return RectangleInfluence(materials_, grid_.spacing[0], grid_.spacing[1]).at(0, 0).xx;
}

void HalfSpaceCompliance::precondition_tangential(const contact::TangentialField& r,
                                                  contact::TangentialField& z) const {
    if (!inverse_) prepare_tangential();
    periodic_.apply(*inverse_, r.x, r.y, z.x, z.y);
}

}  // namespace tricontact::bem
