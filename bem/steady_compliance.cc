#include "bem/steady_compliance.h"

#include <cmath>
#include <cstdlib>

// Steady rolling on a relaxing body: docs/explanation/rolling.md and
// docs/explanation/models/relaxation.md. A cell of the material has been loaded by what passed over
// it: the response ahead of a load differs from that behind it, and kernels are neither even nor
// odd. Each is the sum of both parts,
//
//   K(x) = [K(x) + K(-x)]/2 + [K(x) - K(-x)]/2,
//
// one with a real symbol, one with an imaginary one, and a product is two convolutions.
//
// The preconditioners are the inverses of the even parts on the bare grid.

namespace tricontact::bem {

namespace {

using Coefficient = double InfluenceCoefficients::*;

struct ElasticKernel {
    Coefficient coefficient;
    double parity_x, parity_y;  // its sign on the other side
};
constexpr ElasticKernel elastic_kernels[] = {
    {&InfluenceCoefficients::xx, 1, 1},  {&InfluenceCoefficients::xy, -1, -1},
    {&InfluenceCoefficients::yy, 1, 1},  {&InfluenceCoefficients::xz, -1, 1},
    {&InfluenceCoefficients::yz, 1, -1}, {&InfluenceCoefficients::zz, 1, 1}};

/// Farthest relative position on a padded grid along one side, in cells.
int farthest_position(int n) {
    return good_fft_size(2 * n - 1) / 2;
}

void add(std::span<double> sum, std::span<const double> other) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other[i];
}

}  // namespace

struct SteadyGridCompliance::Table {
    int foremost = 0;  // along x
    std::array<std::vector<double>, n_components> values;

    std::size_t row(int j) const { return static_cast<std::size_t>(j) * (2 * foremost + 1); }
    double at(Component c, int i, int j) const {
        return (j < 0 ? elastic_kernels[c].parity_y : 1) *
               values[c][row(std::abs(j)) + (foremost - i)];
    }
    /// Even or odd under (x, y) -> (-x, -y).
    GridConvolution::Symbol symbol(const GridConvolution& convolution, Component c,
                                   GridConvolution::Parity parity) const {
        const double sign = parity == GridConvolution::Parity::even ? 1 : -1;
        return convolution.symbol(
            [&](int i, int j) { return (at(c, i, j) + sign * at(c, -i, -j)) / 2; }, parity);
    }
};

// Rows along x are complete, of both signs, for what is ahead differs from what is behind; rows
// along y are j >= 0, by parity. Coefficients beyond the grid (`ahead`) enter the creep, but no
// convolution.
SteadyGridCompliance::Table SteadyGridCompliance::crept(const std::vector<CellInfluence>& bodies,
                                                        const contact::CreepModes& modes,
                                                        double speed) const {
    constexpr int cells_beyond = 2;  // what a short branch remembers is forgotten on the way
    Table table{farthest_position(grid_.n_x) + cells_beyond, {}};
    const double h = grid_.spacing[0], distance = table.foremost * h;
    const contact::CreepAlongWay creep(modes.creep, speed, h, distance);
    const int n_rows = farthest_position(grid_.n_y) + 1;
    const std::size_t length = table.row(1), n_ahead = creep.ahead().size();
    for (auto& values : table.values) values.assign(length * n_rows, 0);

    std::vector<std::vector<InfluenceCoefficients>> near(bodies.size()), far(bodies.size());
    std::vector<double> cells(length), ahead(n_ahead);
    for (int j = 0; j < n_rows; ++j) {
        const double y = j * grid_.spacing[1];
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            near[b].clear();
            far[b].clear();
            for (int i = 0; i <= table.foremost; ++i) near[b].push_back(bodies[b](i * h, y));
            for (const double s : creep.ahead()) far[b].push_back(bodies[b](distance + s, y));
        }
        for (int c = 0; c < n_components; ++c) {
            if (!coupled_ && (c == xz || c == yz)) continue;
            const auto& [coefficient, parity_x, parity_y] = elastic_kernels[c];
            for (std::size_t m = 0; m < modes.creep.size(); ++m) {
                cells.assign(length, 0);
                ahead.assign(n_ahead, 0);
                for (std::size_t b = 0; b < bodies.size(); ++b) {
                    const double weight = modes.weight(m, b);
                    for (int k = 0; k < static_cast<int>(length); ++k) {
                        const int i = table.foremost - k;
                        cells[k] +=
                            weight * (i < 0 ? parity_x : 1) * near[b][std::abs(i)].*coefficient;
                    }
                    for (std::size_t q = 0; q < n_ahead; ++q)
                        ahead[q] += weight * far[b][q].*coefficient;
                }
                creep.add(m, cells, ahead,
                          std::span(table.values[c]).subspan(table.row(j), length));
            }
        }
    }
    return table;
}

SteadyGridCompliance::SteadyGridCompliance(const std::vector<CellInfluence>& bodies,
                                           const contact::CreepModes& modes, double speed,
                                           contact::ContactPoints grid, bool coupled)
    : grid_(std::move(grid)),
      coupled_(coupled),
      linear_(grid_.n_x, grid_.n_y, good_fft_size(2 * grid_.n_x - 1),
              good_fft_size(2 * grid_.n_y - 1), 1),
      periodic_(grid_.n_x, grid_.n_y, good_fft_size(grid_.n_x), good_fft_size(grid_.n_y), 1),
      odd_(grid_.size()) {
    using Parity = GridConvolution::Parity;
    const Table table = crept(bodies, modes, speed);
    local_ = table.at(xx, 0, 0);
    for (int c = 0; c < n_components; ++c) {
        const auto component = static_cast<Component>(c);
        if (coupled_ || (c != xz && c != yz))
            kernels_[c] = {table.symbol(linear_, component, Parity::even),
                           table.symbol(linear_, component, Parity::odd)};
    }
    const auto on_grid = [&](Component c) { return table.symbol(periodic_, c, Parity::even); };
    inverse_tangential_ = inverse({on_grid(xx), on_grid(xy), on_grid(yy)});
    const GridConvolution::Symbol normal = on_grid(zz);
    inverse_normal_ = inverse({normal, GridConvolution::Symbol(normal.size(), 0), normal}).xx;
}

using Phase = GridConvolution::Phase;

void SteadyGridCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    const Symbols& k = kernels_[zz];
    linear_.apply<1, 1>({{{&k.even}}}, {p}, {u_z});
    linear_.apply<1, 1, Phase::forward>({{{&k.odd}}}, {p}, {odd_.x});
    add(u_z, odd_.x);
}

void SteadyGridCompliance::tangential(const contact::TangentialField& t,
                                      contact::TangentialField& u) const {
    const auto &k_xx = kernels_[xx], &k_xy = kernels_[xy], &k_yy = kernels_[yy];
    linear_.apply<2, 2, Phase::forward>({{{&k_xx.odd, &k_xy.odd}, {&k_xy.odd, &k_yy.odd}}},
                                        {t.x, t.y}, {odd_.x, odd_.y});
    linear_.apply<2, 2>({{{&k_xx.even, &k_xy.even}, {&k_xy.even, &k_yy.even}}}, {t.x, t.y},
                        {u.x, u.y});
    add(u.x, odd_.x);
    add(u.y, odd_.y);
}

void SteadyGridCompliance::tangential_from_normal(std::span<const double> p,
                                                  contact::TangentialField& u) const {
    if (!coupled_) return Compliance::tangential_from_normal(p, u);
    linear_.apply<2, 1>({{{&kernels_[xz].even}, {&kernels_[yz].even}}}, {p}, {u.x, u.y});
    linear_.apply<2, 1, Phase::forward>({{{&kernels_[xz].odd}, {&kernels_[yz].odd}}}, {p},
                                        {odd_.x, odd_.y});
    add(u.x, odd_.x);
    add(u.y, odd_.y);
}

/// By zx = -xz and zy = -yz of elastic bodies, which creep alike.
void SteadyGridCompliance::normal_from_tangential(const contact::TangentialField& t,
                                                  std::span<double> u_z) const {
    if (!coupled_) return Compliance::normal_from_tangential(t, u_z);
    linear_.apply<1, 2>({{{&kernels_[xz].even, &kernels_[yz].even}}}, {t.x, t.y}, {odd_.x});
    linear_.apply<1, 2, Phase::backward>({{{&kernels_[xz].odd, &kernels_[yz].odd}}}, {t.x, t.y},
                                         {u_z});
    for (std::size_t i = 0; i < u_z.size(); ++i) u_z[i] -= odd_.x[i];
}

void SteadyGridCompliance::precondition_tangential(const contact::TangentialField& r,
                                                   contact::TangentialField& z) const {
    const GridConvolution::Symbol2& s = inverse_tangential_;
    periodic_.apply<2, 2>({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}}, {r.x, r.y}, {z.x, z.y});
}

void SteadyGridCompliance::precondition_normal(std::span<const double> r,
                                               std::span<double> z) const {
    periodic_.apply<1, 1>({{{&inverse_normal_}}}, {r}, {z});
}

}  // namespace tricontact::bem
