#include "bem/grid_compliance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bem/grid_symbols.h"
#include "bem/mirrored_convolution.h"
#include "bem/plane_layer_influence.h"
#include "contact/base/error.h"
#include "contact/compliances/active_operator.h"
#include "contact/compliances/scattered_points.h"
#include "contact/substrates/normal_tangential.h"

// Elasticity on the cells of a grid, docs/explanation/models/bem.md and bem-layer.md: influence
// coefficients of one cell at all relative positions (`Quadrants`: x, y >= 0, the rest by parity),
// transformed once, and two convolutions per product.
//
//   xx, yy, zz   even in x and in y      xz   odd in x, even in y
//   xy           odd in both             yz   even in x, odd in y
//
// The symbols of the bare, periodic grid are inverted per wave number for the preconditioner
// (`inverse`): 2 x 2 for tangential fields, since xy couples them.
//
// `among`: a contact that fills a small part of the grid is multiplied on a window around it.
// Periods are rounded up to lengths that FFTW is fast at, and windows of one such size share their
// symbols.

namespace tricontact::bem {

namespace {

/// Below this many cells normal contact takes less time than it is worth to shorten.
constexpr std::size_t cells_worth_levels = 100000;

/// A window on the grid pays where its transforms are this much smaller.
constexpr double window_worth = .8;

/// Of the products on a grid.
int row_period(const contact::ContactPoints& grid, int n) {
    return grid.mirrored ? MirroredConvolution::row_period(n) : GridConvolution::row_period(n);
}

/// The largest number of cells that this padded size has room for.
int cells_in(int period) {
    return (period + 1) / 2;
}

/// Among points of a grid, or of a window on it, which knows normal products too.
class ConvolvedOperator final : public contact::ActiveOperator {
  public:
    ConvolvedOperator(const ConvolvedProducts& products, contact::ScatteredPoints points)
        : products_(&products), points_(std::move(points)) {}
    ConvolvedOperator(std::shared_ptr<const ConvolvedProducts> window,
                      contact::ScatteredPoints points)
        : window_(std::move(window)), products_(window_.get()), points_(std::move(points)) {}

    void apply(const contact::TangentialField& t, contact::TangentialField& u) const override {
        points_.apply(t, u, [&](const auto& in, auto& out) { products_->tangential(in, out); });
    }
    void precondition(const contact::TangentialField& r,
                      contact::TangentialField& z) const override {
        points_.apply(
            r, z, [&](const auto& in, auto& out) { products_->precondition_tangential(in, out); });
    }

    bool knows_layers() const override { return true; }
    void precondition_under(const contact::LayerCompliance& layer,
                            const contact::TangentialField& r,
                            contact::TangentialField& z) const override {
        points_.apply(r, z, [&](const auto& in, auto& out) {
            products_->precondition_under(layer, in, out);
        });
    }

    bool has_normal() const override { return window_ != nullptr; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        points_.apply(p, u_z, [&](auto in, auto out) { products_->normal(in, out); });
    }
    void precondition_normal(std::span<const double> r, std::span<double> z) const override {
        points_.apply(r, z, [&](auto in, auto out) { products_->precondition_normal(in, out); });
    }

  private:
    std::shared_ptr<const ConvolvedProducts> window_;
    const ConvolvedProducts* products_;
    contact::ScatteredPoints points_;
};

}  // namespace

const contact::NormalGrid* ConvolvedCompliance::normal_grid() const {
    if (grid_.mirrored || grid_.size() < cells_worth_levels) return nullptr;
    return products_->normal_grid(grid_.area[0]);
}

std::unique_ptr<const contact::ActiveOperator> ConvolvedCompliance::among(
    const std::vector<std::size_t>& active) const {
    return std::make_unique<ConvolvedOperator>(
        *products_, contact::ScatteredPoints(active, grid_.size(), n_threads_));
}

void ConvolvedCompliance::tangential_from_normal(std::span<const double> p,
                                                 contact::TangentialField& u) const {
    if (!coupled_) return Compliance::tangential_from_normal(p, u);
    products_->tangential_from_normal(p, u);
}

void ConvolvedCompliance::normal_from_tangential(const contact::TangentialField& t,
                                                 std::span<double> u_z) const {
    if (!coupled_) return Compliance::normal_from_tangential(t, u_z);
    products_->normal_from_tangential(t, u_z);
}

GridCompliance::GridCompliance(CellInfluence influence, contact::ContactPoints grid, bool coupled,
                               int n_threads, const contact::Interface& interface)
    : ConvolvedCompliance(std::move(grid), coupled, n_threads) {
    take(
        std::make_shared<const GridSymbols>(on_interface(std::move(influence), interface), shape()),
        interface);
}

GridCompliance::GridCompliance(const contact::MaterialPair& materials, contact::ContactPoints grid,
                               int n_threads, const contact::Interface& interface)
    : ConvolvedCompliance(std::move(grid), bem::is_coupled(materials), n_threads) {
    take(half_space_symbols(materials, interface, shape()), interface);
}

GridShape GridCompliance::shape() const {
    return {grid_.n_x, grid_.n_y, grid_.spacing, grid_.mirrored, coupled_, n_threads_};
}

void GridCompliance::take(std::shared_ptr<const GridSymbols> symbols,
                          const contact::Interface& interface) {
    grid_.on_springs = interface.is_elastic();
    products_ = {symbols, &symbols->whole()};
    symbols_ = std::move(symbols);
}

// A window's period is rounded up to a good length of transforms, and its cells to all that this
// length has room for. A contact that grows by a row then keeps its window, and windows of one size
// share their symbols (`windows_`).
std::unique_ptr<const contact::ActiveOperator> GridCompliance::among(
    const std::vector<std::size_t>& active) const {
    if (active.empty()) return ConvolvedCompliance::among(active);
    int low_x = grid_.n_x, high_x = 0, low_y = grid_.n_y, high_y = 0;
    for (const std::size_t point : active) {
        const int i = static_cast<int>(point) % grid_.n_x, j = static_cast<int>(point) / grid_.n_x;
        low_x = std::min(low_x, i), high_x = std::max(high_x, i);
        low_y = std::min(low_y, j), high_y = std::max(high_y, j);
    }
    if (grid_.mirrored) low_y = 0;
    const int period_x = row_period(grid_, 2 * (high_x - low_x) + 1);
    const int period_y = padded(all_rows(grid_.mirrored, high_y - low_y + 1));
    const int n_y = cells_in(period_y);
    const GridSymbols::Size size{cells_in(period_x), grid_.mirrored ? (n_y + 1) / 2 : n_y};
    const double cells = static_cast<double>(period_x) * period_y;
    const double all_cells = static_cast<double>(row_period(grid_, 2 * grid_.n_x - 1)) *
                             padded(all_rows(grid_.mirrored, grid_.n_y));
    if (cells > window_worth * all_cells) return ConvolvedCompliance::among(active);
    std::vector<std::size_t> positions;
    for (const std::size_t point : active) {
        const std::size_t i = point % grid_.n_x - low_x, j = point / grid_.n_x - low_y;
        positions.push_back(j * size[0] + i);
    }
    const std::size_t n_cells = static_cast<std::size_t>(size[0]) * size[1];
    return std::make_unique<ConvolvedOperator>(
        symbols_->window(size), contact::ScatteredPoints(std::move(positions), n_cells,
                                                         n_threads_worth(n_cells, n_threads_)));
}

void GridCompliance::displacements(const std::vector<const GridCompliance*>& bodies,
                                   const contact::SurfaceField& t,
                                   std::span<contact::SurfaceField> u) {
    ConvolvedProducts::Bodies products;
    for (const GridCompliance* body : bodies) products.push_back(body->products_.get());
    products.front()->displacements(products, t, u);
}

InfluenceTable GridCompliance::influence() const {
    InfluenceTable table{
        grid_.spacing[0], symbols_->quadrants().columns(), symbols_->quadrants().rows(), {}};
    for (int j = 0; j < table.n_y; ++j)
        for (int i = 0; i < table.n_x; ++i) table.cells.push_back(symbols_->quadrants().at(i, j));
    return table;
}

std::unique_ptr<const contact::Interior> GridCompliance::interior(
    std::span<const double> p, const contact::TangentialField& t) const {
    if (!view_) return nullptr;
    if (!grid_.mirrored)
        return std::make_unique<contact::Interior>(grid_interior(*view_, grid_, p, t));
    const int n_x = grid_.n_x, n_y = all_rows(grid_.mirrored, grid_.n_y);
    const auto whole = contact::ContactPoints::grid(
        n_x, n_y, {grid_.first[0], -(grid_.n_y - 1) * grid_.spacing[1]}, grid_.spacing);
    std::vector<double> pressure(whole.size());
    contact::TangentialField traction(whole.size());
    for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i) {
            const int side = j < grid_.n_y - 1 ? -1 : 1, row = std::abs(j - (grid_.n_y - 1));
            const std::size_t to = static_cast<std::size_t>(j) * n_x + i;
            const std::size_t from = static_cast<std::size_t>(row) * n_x + i;
            pressure[to] = p[from];
            traction.set(to, {t.x[from], side * t.y[from]});
        }
    return std::make_unique<contact::Interior>(grid_interior(*view_, whole, pressure, traction));
}

bool is_coupled(const contact::MaterialPair& materials) {
    return contact::half_spaces_couple(materials);
}

std::unique_ptr<GridCompliance> half_space_compliance(const contact::MaterialPair& materials,
                                                      contact::ContactPoints grid, int n_threads,
                                                      const contact::Interface& interface) {
    return std::make_unique<GridCompliance>(materials, std::move(grid), n_threads, interface);
}

std::unique_ptr<GridCompliance> layer_compliance(const theory::LayerStack& layers,
                                                 const std::optional<contact::Material>& indenter,
                                                 contact::ContactPoints grid, int n_threads,
                                                 const contact::Interface& interface) {
    const auto cell = std::make_shared<const LayerInfluence>(
        layers, indenter, grid.spacing[0], grid.spacing[1],
        std::hypot(positions(grid.n_x) * grid.spacing[0],
                   positions(all_rows(grid.mirrored, grid.n_y)) * grid.spacing[1]));
    return std::make_unique<GridCompliance>([cell](double x, double y) { return cell->at(x, y); },
                                            std::move(grid), true, n_threads, interface);
}

std::unique_ptr<GridCompliance> plane_layer_compliance(
    const theory::LayerStack& layers, const std::optional<contact::Material>& indenter,
    contact::ContactPoints grid, int n_threads, const contact::Interface& interface) {
    const auto strip = std::make_shared<const PlaneLayerInfluence>(
        layers, indenter, grid.spacing[0], grid.spacing[1], positions(grid.n_x) * grid.spacing[0]);
    // Beside the only row there is nothing.
    return std::make_unique<GridCompliance>(
        [strip](double x, double y) { return y == 0 ? strip->at(x) : InfluenceCoefficients{}; },
        std::move(grid), true, n_threads, interface);
}

std::unique_ptr<GridCompliance> tabulated_compliance(InfluenceTable table, const std::string& name,
                                                     bool coupled, contact::ContactPoints grid,
                                                     int n_threads,
                                                     const contact::Interface& interface) {
    const double h = grid.spacing[0];
    check_spacing(table, name, h);
    const int n_x = grid.n_x, n_y = all_rows(grid.mirrored, grid.n_y);
    if (table.n_x < n_x || table.n_y < n_y)
        throw contact::InputError(
            fmt::format("{}: {} x {} positions, but contact and rolling path need {} x {}; write "
                        "the file again",
                        name, table.n_x, table.n_y, n_x, n_y));
    const auto shared = std::make_shared<const InfluenceTable>(std::move(table));
    return std::make_unique<GridCompliance>(
        // Farther than the cells lie apart are positions of the padding alone, which nothing reads.
        [shared, h](double x, double y) {
            return shared->at(std::min(static_cast<int>(std::lround(x / h)), shared->n_x - 1),
                              std::min(static_cast<int>(std::lround(y / h)), shared->n_y - 1));
        },
        std::move(grid), coupled, n_threads, interface);
}

}  // namespace tricontact::bem
