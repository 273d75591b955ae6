#include "bem/grid_compliance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

/// A window on the grid pays where its transforms are this much smaller, and few of them do.
constexpr double window_worth = .8;
constexpr std::size_t most_windows = 8;

/// Of the plane: a mirrored grid's, with the other side of y = 0.
int all_rows(const contact::ContactPoints& grid, int n_y) {
    return grid.mirrored ? 2 * n_y - 1 : n_y;
}

int padded(int n) {
    return good_complex_fft_size(2 * n - 1);
}

/// Relative positions of i >= 0 cells on a padded grid along one side.
int positions(int n) {
    return good_fft_size(2 * n - 1) / 2 + 1;
}

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

int n_threads_worth(std::size_t n_cells, int n_threads) {
    constexpr std::size_t worth_threads = 100000;  // below, one costs more than it brings
    return n_cells < worth_threads ? 1 : n_threads;
}

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
    : ConvolvedCompliance(std::move(grid), coupled, n_threads),
      quadrants_(on_interface(std::move(influence), interface), positions(grid_.n_x),
                 positions(all_rows(grid_, grid_.n_y)), grid_.spacing, n_threads_) {
    grid_.on_springs = interface.is_elastic();
    const Size whole{grid_.n_x, grid_.n_y};
    products_ = grid_.mirrored ? make_products<MirroredConvolution>(whole, false)
                               : make_products<GridConvolution>(whole, false);
}

const std::vector<Quadrants::Quadrant>& GridCompliance::tangential_quadrants() const {
    using K = InfluenceCoefficients;
    if (tangential_quadrants_.empty()) {
        std::vector<Quadrants::Coefficient> which{&K::xx, &K::xy, &K::yy};
        if (coupled_) which.insert(which.end(), {&K::xz, &K::yz});
        tangential_quadrants_ = quadrants_.of(which);
    }
    return tangential_quadrants_;
}

/// Kept for the windows, whose number grows with the contact.
GridConvolution::Symbol GridCompliance::normal_symbol(const auto& convolution) const {
    if (normal_quadrant_.empty())
        normal_quadrant_ = std::move(quadrants_.of({&InfluenceCoefficients::zz})[0]);
    return quadrants_.symbol(convolution, normal_quadrant_, 1, 1);
}

// A normal contact alone needs K_zz, half of the memory; the other symbols are made when friction
// asks for them (`rest`).
/// On the grid or a window on it.
template <class Convolution>
std::unique_ptr<const ConvolvedProducts> GridCompliance::make_products(const Size& size,
                                                                       bool is_window) const {
    const auto [n_x, n_y] = size;
    const int n_all = all_rows(grid_, n_y);
    const int n_threads = n_threads_worth(static_cast<std::size_t>(n_x) * n_y, n_threads_);
    Convolution linear(n_x, n_y, Convolution::row_period(2 * n_x - 1), padded(n_all), n_threads);
    Convolution periodic(n_x, n_y, Convolution::row_period(n_x), good_complex_fft_size(n_all),
                         n_threads);
    auto rest = [this, is_window](const Convolution& convolution, const Convolution& bare) {
        const auto& k = tangential_quadrants();
        auto symbol2 = [&](const Convolution& by) {
            return GridConvolution::Symbol2{quadrants_.symbol(by, k[0], 1, 1),
                                            quadrants_.symbol(by, k[1], -1, -1),
                                            quadrants_.symbol(by, k[2], 1, 1)};
        };
        TangentialSymbols made{.tangential = symbol2(convolution),
                               .inverse = inverse(symbol2(bare), bare.n_threads())};
        if (!coupled_ || is_window) return made;
        made.from_normal_x = quadrants_.symbol(convolution, k[3], -1, 1);
        made.from_normal_y = quadrants_.symbol(convolution, k[4], 1, -1);
        return made;
    };
    if (!is_window) {
        auto normal = normal_symbol(linear);
        if (grid_.size() >= cells_worth_levels) normal_quadrant_ = {};  // windows are few there
        return std::make_unique<ProductsBy<Convolution>>(std::move(linear), std::move(periodic),
                                                         std::move(normal), std::move(rest));
    }
    auto normal = [this](const Convolution& convolution, const Convolution& bare) {
        const GridConvolution::Symbol periodic_normal = normal_symbol(bare);
        const GridConvolution::Symbol none(periodic_normal.size(), 0);
        return NormalSymbols{
            normal_symbol(convolution),
            inverse({periodic_normal, none, periodic_normal}, bare.n_threads()).xx};
    };
    return std::make_unique<ProductsBy<Convolution>>(std::move(linear), std::move(periodic),
                                                     std::move(normal), std::move(rest));
}

std::shared_ptr<const ConvolvedProducts> GridCompliance::window(const Size& size) const {
    if (windows_.size() >= most_windows && !windows_.contains(size)) windows_.clear();
    auto& products = windows_[size];
    if (!products)
        products = grid_.mirrored ? make_products<MirroredConvolution>(size, true)
                                  : make_products<GridConvolution>(size, true);
    return products;
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
    const int period_y = padded(all_rows(grid_, high_y - low_y + 1));
    const int n_y = cells_in(period_y);
    const Size size{cells_in(period_x), grid_.mirrored ? (n_y + 1) / 2 : n_y};
    const double cells = static_cast<double>(period_x) * period_y;
    const double all_cells = static_cast<double>(row_period(grid_, 2 * grid_.n_x - 1)) *
                             padded(all_rows(grid_, grid_.n_y));
    if (cells > window_worth * all_cells) return ConvolvedCompliance::among(active);
    std::vector<std::size_t> positions;
    for (const std::size_t point : active) {
        const std::size_t i = point % grid_.n_x - low_x, j = point / grid_.n_x - low_y;
        positions.push_back(j * size[0] + i);
    }
    const std::size_t n_cells = static_cast<std::size_t>(size[0]) * size[1];
    return std::make_unique<ConvolvedOperator>(
        window(size), contact::ScatteredPoints(std::move(positions), n_cells,
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
    InfluenceTable table{grid_.spacing[0], quadrants_.columns(), quadrants_.rows(), {}};
    for (int j = 0; j < table.n_y; ++j)
        for (int i = 0; i < table.n_x; ++i) table.cells.push_back(quadrants_.at(i, j));
    return table;
}

std::unique_ptr<const contact::Interior> GridCompliance::interior(
    std::span<const double> p, const contact::TangentialField& t) const {
    if (!view_) return nullptr;
    if (!grid_.mirrored)
        return std::make_unique<contact::Interior>(grid_interior(*view_, grid_, p, t));
    const int n_x = grid_.n_x, n_y = all_rows(grid_, grid_.n_y);
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
    const RectangleInfluence cell(materials, grid.spacing[0], grid.spacing[1]);
    return std::make_unique<GridCompliance>([cell](double x, double y) { return cell.at(x, y); },
                                            std::move(grid), is_coupled(materials), n_threads,
                                            interface);
}

std::unique_ptr<GridCompliance> layer_compliance(const theory::LayerStack& layers,
                                                 const std::optional<contact::Material>& indenter,
                                                 contact::ContactPoints grid, int n_threads,
                                                 const contact::Interface& interface) {
    const auto cell = std::make_shared<const LayerInfluence>(
        layers, indenter, grid.spacing[0], grid.spacing[1],
        std::hypot(positions(grid.n_x) * grid.spacing[0],
                   positions(all_rows(grid, grid.n_y)) * grid.spacing[1]));
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
    const int n_x = grid.n_x, n_y = all_rows(grid, grid.n_y);
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
