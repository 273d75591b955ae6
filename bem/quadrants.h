#pragma once

#include <cstdlib>
#include <functional>
#include <vector>

#include "bem/grid_convolution.h"
#include "bem/influence.h"
#include "contact/base/vector2.h"
#include "contact/interface.h"

namespace tricontact::bem {

/// The coefficients of one cell at a relative position [m].
using CellInfluence = std::function<InfluenceCoefficients(double x, double y)>;

/// What the springs of an interface add to the coefficients of a cell on itself.
InfluenceCoefficients springs_of(const contact::Interface& interface);
/// The coefficients of bodies with these springs.
CellInfluence on_interface(CellInfluence bodies, const contact::Interface& interface);

/// Influence coefficients of cells at all relative positions of i, j >= 0 cells.
class Quadrants {
  public:
    /// Results do not depend on `n_threads`.
    Quadrants(CellInfluence influence, int columns, int rows, contact::Vector2 spacing,
              int n_threads);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    InfluenceCoefficients at(int i, int j) const {
        return influence_(i * spacing_[0], j * spacing_[1]);
    }

    using Coefficient = double InfluenceCoefficients::*;
    /// One of them everywhere, i fastest.
    using Quadrant = std::vector<double>;
    std::vector<Quadrant> of(const std::vector<Coefficient>& which) const;

    /// Symbol of a convolution that reaches no farther, whatever its period. `parity_x`,
    /// `parity_y`: sign of the coefficient on the other side.
    template <class Convolution>
    GridConvolution::Symbol symbol(const Convolution& convolution, const Quadrant& quadrant,
                                   double parity_x, double parity_y) const {
        const auto parity =
            parity_x * parity_y < 0 ? GridConvolution::Parity::odd : GridConvolution::Parity::even;
        return convolution.symbol(
            [&](int i, int j) {
                if (std::abs(i) >= columns_ || std::abs(j) >= rows_) return 0.;
                const double sign = (i < 0 ? parity_x : 1) * (j < 0 ? parity_y : 1);
                return sign *
                       quadrant[static_cast<std::size_t>(std::abs(j)) * columns_ + std::abs(i)];
            },
            parity);
    }

  private:
    CellInfluence influence_;
    int columns_, rows_;
    contact::Vector2 spacing_;
    int n_threads_;
};

}  // namespace tricontact::bem
