#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "bem/convolved_products.h"
#include "bem/quadrants.h"
#include "contact/base/vector2.h"
#include "contact/interface.h"
#include "contact/substrates/material.h"

namespace tricontact::bem {

/// Threads that a grid of so many cells is worth.
int n_threads_worth(std::size_t n_cells, int n_threads);

/// The cells of a grid, wherever it lies.
struct GridShape {
    int n_x, n_y;
    contact::Vector2 spacing;  ///< [m]
    bool mirrored;             ///< the first row is at y = 0
    bool coupled;              ///< coefficients between normal and tangential are used
    int n_threads;

    bool operator==(const GridShape&) const = default;
    std::size_t size() const { return static_cast<std::size_t>(n_x) * n_y; }
};

/// Products with the influence coefficients of a GridShape, on all of it and on windows: what
/// depends on cells and bodies alone. Made when first asked for; one caller at a time.
class GridSymbols {
  public:
    using Size = std::array<int, 2>;  // columns, rows

    GridSymbols(CellInfluence influence, const GridShape& shape);
    GridSymbols(const GridSymbols&) = delete;
    GridSymbols& operator=(const GridSymbols&) = delete;

    const GridShape& shape() const { return shape_; }
    const Quadrants& quadrants() const { return quadrants_; }
    const ConvolvedProducts& whole() const { return *whole_; }
    std::shared_ptr<const ConvolvedProducts> window(const Size& size) const;

  private:
    template <class Convolution>
    std::unique_ptr<const ConvolvedProducts> make_products(const Size& size, bool is_window) const;
    GridConvolution::Symbol normal_symbol(const auto& convolution) const;
    std::vector<Quadrants::Coefficient> tangential_coefficients() const;
    const std::vector<Quadrants::Quadrant>& tangential_quadrants() const;

    const GridShape shape_;
    const Quadrants quadrants_;
    mutable Quadrants::Quadrant normal_quadrant_;                    // once asked for
    mutable std::vector<Quadrants::Quadrant> tangential_quadrants_;  // xx, xy, yy, coupled xz, yz
    mutable std::map<Size, std::shared_ptr<const ConvolvedProducts>> windows_;  // by their size
    std::unique_ptr<const ConvolvedProducts> whole_;
};

/// Those of half-spaces. On small grids they outlive who asked for them, a bounded number for each
/// process, and serve the next on the same cells: a short case takes a third of its time to make
/// them. Nobody else has them meanwhile.
std::shared_ptr<const GridSymbols> half_space_symbols(const contact::MaterialPair& materials,
                                                      const contact::Interface& interface,
                                                      const GridShape& shape);

/// Of the plane: a mirrored grid's, with the other side of y = 0.
int all_rows(bool mirrored, int n_y);

/// Period along y of the linear convolution of so many rows.
int padded(int n);

/// Relative positions of i >= 0 cells on a padded grid along one side.
int positions(int n);

}  // namespace tricontact::bem
