#include "bem/grid_compliance.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "bem/plane_layer_influence.h"
#include "contact/error.h"

namespace tricontact::bem {

namespace {

using Symbol2 = GridConvolution::Symbol2;
using Phase = GridConvolution::Phase;

/// Below this many cells a thread costs more than it brings.
constexpr std::size_t cells_worth_threads = 100000;

constexpr double negligible_beta = 1e-3;

/// Relative positions of i >= 0 cells on a padded grid along one side.
int positions(int n) {
    return good_fft_size(2 * n - 1) / 2 + 1;
}

}  // namespace

const ConvolvedCompliance::Symbols& ConvolvedCompliance::symbols() const {
    if (!symbols_) symbols_ = make_symbols();
    return *symbols_;
}

void ConvolvedCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    convolution().apply<1, 1>({{{&normal_}}}, {p}, {u_z});
}

void ConvolvedCompliance::tangential(const contact::TangentialField& t,
                                     contact::TangentialField& u) const {
    const Symbol2& s = symbols().tangential;
    convolution().apply<2, 2>({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}}, {t.x, t.y}, {u.x, u.y});
}

void ConvolvedCompliance::tangential_from_normal(std::span<const double> p,
                                                 contact::TangentialField& u) const {
    if (!coupled_) return Compliance::tangential_from_normal(p, u);
    const Symbols& s = symbols();
    convolution().apply<2, 1, Phase::forward>({{{&s.from_normal_x}, {&s.from_normal_y}}}, {p},
                                              {u.x, u.y});
}

void ConvolvedCompliance::normal_from_tangential(const contact::TangentialField& t,
                                                 std::span<double> u_z) const {
    if (!coupled_) return Compliance::normal_from_tangential(t, u_z);
    const Symbols& s = symbols();
    convolution().apply<1, 2, Phase::backward>({{{&s.from_normal_x, &s.from_normal_y}}}, {t.x, t.y},
                                               {u_z});
}

void ConvolvedCompliance::precondition_tangential(const contact::TangentialField& r,
                                                  contact::TangentialField& z) const {
    const Symbol2& s = symbols().inverse;
    preconditioner().apply<2, 2>({{{&s.xx, &s.xy}, {&s.xy, &s.yy}}}, {r.x, r.y}, {z.x, z.y});
}

GridCompliance::GridCompliance(Influence influence, contact::ContactPoints grid, bool coupled,
                               int n_threads)
    : ConvolvedCompliance(std::move(grid), coupled),
      influence_(std::move(influence)),
      n_threads_(grid_.size() < cells_worth_threads ? 1 : n_threads),
      linear_(grid_.n_x, grid_.n_y, good_fft_size(2 * grid_.n_x - 1),
              good_fft_size(2 * grid_.n_y - 1), n_threads_),
      periodic_(grid_.n_x, grid_.n_y, good_fft_size(grid_.n_x), good_fft_size(grid_.n_y),
                n_threads_),
      columns_(positions(grid_.n_x)),
      rows_(positions(grid_.n_y)) {
    normal_ = symbol(linear_, quadrants({&InfluenceCoefficients::zz})[0], 1, 1);
}

/// Some coefficients at all relative positions of i, j >= 0 cells, i fastest.
std::vector<std::vector<double>> GridCompliance::quadrants(
    const std::vector<Coefficient>& which) const {
    const std::size_t n = static_cast<std::size_t>(columns_) * rows_;
    std::vector<std::vector<double>> values(which.size(), std::vector<double>(n));
#pragma omp parallel for num_threads(n_threads_) if (n_threads_ > 1) schedule(static)
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            const auto k = influence_(i * grid_.spacing[0], j * grid_.spacing[1]);
            for (std::size_t c = 0; c < which.size(); ++c)
                values[c][static_cast<std::size_t>(j) * columns_ + i] = k.*which[c];
        }
    return values;
}

/// `parity_x`, `parity_y`: sign of the coefficient on the other side.
GridConvolution::Symbol GridCompliance::symbol(const GridConvolution& convolution,
                                               const std::vector<double>& quadrant, double parity_x,
                                               double parity_y) const {
    const auto parity =
        parity_x * parity_y < 0 ? GridConvolution::Parity::odd : GridConvolution::Parity::even;
    return convolution.symbol(
        [&](int i, int j) {
            const double sign = (i < 0 ? parity_x : 1) * (j < 0 ? parity_y : 1);
            return sign * quadrant[static_cast<std::size_t>(std::abs(j)) * columns_ + std::abs(i)];
        },
        parity);
}

ConvolvedCompliance::Symbols GridCompliance::make_symbols() const {
    using K = InfluenceCoefficients;
    const auto k = quadrants({&K::xx, &K::xy, &K::yy, &K::xz, &K::yz});
    auto symbol2 = [&](const GridConvolution& convolution) {
        return Symbol2{symbol(convolution, k[0], 1, 1), symbol(convolution, k[1], -1, -1),
                       symbol(convolution, k[2], 1, 1)};
    };
    Symbols made{.tangential = symbol2(linear_), .inverse = inverse(symbol2(periodic_))};
    if (!coupled_) return made;
    made.from_normal_x = symbol(linear_, k[3], -1, 1);
    made.from_normal_y = symbol(linear_, k[4], 1, -1);
    return made;
}

InfluenceTable GridCompliance::influence() const {
    InfluenceTable table{grid_.spacing[0], columns_, rows_, {}};
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i)
            table.cells.push_back(influence_(i * grid_.spacing[0], j * grid_.spacing[1]));
    return table;
}

bool is_coupled(const contact::MaterialPair& materials) {
    return std::abs(materials.dundurs_beta()) > negligible_beta;
}

std::unique_ptr<GridCompliance> half_space_compliance(const contact::MaterialPair& materials,
                                                      contact::ContactPoints grid, int n_threads) {
    const RectangleInfluence cell(materials, grid.spacing[0], grid.spacing[1]);
    return std::make_unique<GridCompliance>([cell](double x, double y) { return cell.at(x, y); },
                                            std::move(grid), is_coupled(materials), n_threads);
}

std::unique_ptr<GridCompliance> layer_compliance(const theory::LayerStack& layers,
                                                 const std::optional<contact::Material>& indenter,
                                                 contact::ContactPoints grid, int n_threads) {
    const auto cell = std::make_shared<const LayerInfluence>(
        layers, indenter, grid.spacing[0], grid.spacing[1],
        std::hypot(positions(grid.n_x) * grid.spacing[0], positions(grid.n_y) * grid.spacing[1]));
    return std::make_unique<GridCompliance>([cell](double x, double y) { return cell->at(x, y); },
                                            std::move(grid), true, n_threads);
}

std::unique_ptr<GridCompliance> plane_layer_compliance(
    const theory::LayerStack& layers, const std::optional<contact::Material>& indenter,
    contact::ContactPoints grid, int n_threads) {
    const auto strip = std::make_shared<const PlaneLayerInfluence>(
        layers, indenter, grid.spacing[0], grid.spacing[1], positions(grid.n_x) * grid.spacing[0]);
    // Beside the only row there is nothing.
    return std::make_unique<GridCompliance>(
        [strip](double x, double y) { return y == 0 ? strip->at(x) : InfluenceCoefficients{}; },
        std::move(grid), true, n_threads);
}

std::unique_ptr<GridCompliance> tabulated_compliance(InfluenceTable table, const std::string& name,
                                                     bool coupled, contact::ContactPoints grid,
                                                     int n_threads) {
    const double h = grid.spacing[0];
    check_spacing(table, name, h);
    const int n_x = positions(grid.n_x), n_y = positions(grid.n_y);
    if (table.n_x < n_x || table.n_y < n_y)
        throw contact::InputError(
            fmt::format("{}: {} x {} positions, but contact and rolling path need {} x {}; write "
                        "the file again",
                        name, table.n_x, table.n_y, n_x, n_y));
    const auto shared = std::make_shared<const InfluenceTable>(std::move(table));
    return std::make_unique<GridCompliance>(
        [shared, h](double x, double y) {
            return shared->at(static_cast<int>(std::lround(x / h)),
                              static_cast<int>(std::lround(y / h)));
        },
        std::move(grid), coupled, n_threads);
}

}  // namespace tricontact::bem
