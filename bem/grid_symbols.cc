#include "bem/grid_symbols.h"

#include <algorithm>
#include <iterator>
#include <list>
#include <mutex>
#include <new>
#include <utility>

#include "bem/mirrored_convolution.h"

namespace tricontact::bem {

namespace {

/// From here on a normal contact is worth a coarser grid, and its windows are few.
constexpr std::size_t cells_of_few_windows = 100000;

constexpr std::size_t most_windows = 8;

/// Bodies that give way alike [1/Pa, m/Pa] under the cells of a grid.
struct HalfSpaces {
    std::array<double, 5> compliances;
    GridShape shape;

    bool operator==(const HalfSpaces&) const = default;
};

/// Symbols that nobody has just now, the last first. `cells_kept` of them take some 20 MB.
class IdleSymbols {
  public:
    /// Empty if there are none.
    std::unique_ptr<const GridSymbols> take(const HalfSpaces& bodies) {
        const std::lock_guard lock(mutex_);
        for (auto at = idle_.begin(); at != idle_.end(); ++at) {
            if (at->first != bodies) continue;
            auto symbols = std::move(at->second);
            idle_.erase(at);
            return symbols;
        }
        return nullptr;
    }
    void add(const HalfSpaces& bodies, std::unique_ptr<const GridSymbols> symbols) noexcept try {
        constexpr std::size_t cells_kept = 20000, grids_kept = 8;
        if (bodies.shape.size() > cells_kept) return;
        const std::lock_guard lock(mutex_);
        idle_.emplace_front(bodies, std::move(symbols));
        std::size_t cells = 0;
        for (const auto& [of, _] : idle_) cells += of.shape.size();
        for (; cells > cells_kept || idle_.size() > grids_kept; idle_.pop_back())
            cells -= idle_.back().first.shape.size();
    } catch (const std::bad_alloc&) {  // they end here
    }

  private:
    std::mutex mutex_;
    std::list<std::pair<HalfSpaces, std::unique_ptr<const GridSymbols>>> idle_;
};

}  // namespace

int n_threads_worth(std::size_t n_cells, int n_threads) {
    constexpr std::size_t worth_threads = 100000;  // below, one costs more than it brings
    return n_cells < worth_threads ? 1 : n_threads;
}

int all_rows(bool mirrored, int n_y) {
    return mirrored ? 2 * n_y - 1 : n_y;
}

int padded(int n) {
    return good_complex_fft_size(2 * n - 1);
}

int positions(int n) {
    return good_fft_size(2 * n - 1) / 2 + 1;
}

GridSymbols::GridSymbols(CellInfluence influence, const GridShape& shape)
    : shape_(shape),
      quadrants_(std::move(influence), positions(shape.n_x),
                 positions(all_rows(shape.mirrored, shape.n_y)), shape.spacing, shape.n_threads) {
    const Size all{shape.n_x, shape.n_y};
    whole_ = shape.mirrored ? make_products<MirroredConvolution>(all, false)
                            : make_products<GridConvolution>(all, false);
}

std::vector<Quadrants::Coefficient> GridSymbols::tangential_coefficients() const {
    using K = InfluenceCoefficients;
    std::vector<Quadrants::Coefficient> which{&K::xx, &K::xy, &K::yy};
    if (shape_.coupled) which.insert(which.end(), {&K::xz, &K::yz});
    return which;
}

const std::vector<Quadrants::Quadrant>& GridSymbols::tangential_quadrants() const {
    if (tangential_quadrants_.empty())
        tangential_quadrants_ = quadrants_.of(tangential_coefficients());
    return tangential_quadrants_;
}

/// Kept for the windows, whose number grows with the contact. On small grids with those of
/// friction, which one evaluation gives too.
GridConvolution::Symbol GridSymbols::normal_symbol(const auto& convolution) const {
    if (normal_quadrant_.empty()) {
        std::vector<Quadrants::Coefficient> which{&InfluenceCoefficients::zz};
        const bool all = shape_.size() < cells_of_few_windows && tangential_quadrants_.empty();
        if (all) std::ranges::copy(tangential_coefficients(), std::back_inserter(which));
        auto made = quadrants_.of(which);
        normal_quadrant_ = std::move(made.front());
        if (all)
            tangential_quadrants_.assign(std::move_iterator(made.begin() + 1),
                                         std::move_iterator(made.end()));
    }
    return quadrants_.symbol(convolution, normal_quadrant_, 1, 1);
}

// A normal contact alone needs K_zz, half of the memory; the other symbols are made when friction
// asks for them (`rest`).
/// On the grid or a window on it.
template <class Convolution>
std::unique_ptr<const ConvolvedProducts> GridSymbols::make_products(const Size& size,
                                                                    bool is_window) const {
    const auto [n_x, n_y] = size;
    const int n_all = all_rows(shape_.mirrored, n_y);
    const int n_threads = n_threads_worth(static_cast<std::size_t>(n_x) * n_y, shape_.n_threads);
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
        if (!shape_.coupled || is_window) return made;
        made.from_normal_x = quadrants_.symbol(convolution, k[3], -1, 1);
        made.from_normal_y = quadrants_.symbol(convolution, k[4], 1, -1);
        return made;
    };
    if (!is_window) {
        auto normal = normal_symbol(linear);
        if (shape_.size() >= cells_of_few_windows) normal_quadrant_ = {};  // windows are few there
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

std::shared_ptr<const ConvolvedProducts> GridSymbols::window(const Size& size) const {
    if (windows_.size() >= most_windows && !windows_.contains(size)) windows_.clear();
    auto& products = windows_[size];
    if (!products)
        products = shape_.mirrored ? make_products<MirroredConvolution>(size, true)
                                   : make_products<GridConvolution>(size, true);
    return products;
}

std::shared_ptr<const GridSymbols> half_space_symbols(const contact::MaterialPair& materials,
                                                      const contact::Interface& interface,
                                                      const GridShape& shape) {
    static IdleSymbols& idle = *new IdleSymbols;  // outlives all models, whoever owns them
    const HalfSpaces bodies{{materials.one_minus_nu_over_g(), materials.nu_over_g(),
                             materials.one_minus_two_nu_over_g(), interface.normal_compliance(),
                             interface.tangential_compliance()},
                            shape};
    auto symbols = idle.take(bodies);
    if (!symbols) {
        const RectangleInfluence cell(materials, shape.spacing[0], shape.spacing[1]);
        symbols = std::make_unique<const GridSymbols>(
            on_interface([cell](double x, double y) { return cell.at(x, y); }, interface), shape);
    }
    return {symbols.release(), [bodies](const GridSymbols* done) {
                idle.add(bodies, std::unique_ptr<const GridSymbols>(done));
            }};
}

}  // namespace tricontact::bem
