#pragma once

#include <array>

#include "contact/substrates/material.h"
#include "fem/q2_space.h"

// The element: docs/explanation/models/fem.md, "Elements". Derivation of the projected dilatation:
// element.cc.

namespace tricontact::fem {

/// Moduli as the elements see them.
struct Moduli {
    double shear;  ///< G [Pa]
    double bulk;   ///< K [Pa], at most `largest_bulk_ratio` G
};
Moduli moduli_of(const contact::Material& material, double largest_bulk_ratio);

/// Linear functions over an element and the projection of the volumetric strain onto them.
class Dilatation {
  public:
    /// Displacement of node i in direction a is entry a * 27 + i.
    using Row = std::array<double, 81>;

    /// `values` as reinitialised on the element, with enough points for the element's volume.
    explicit Dilatation(const ElementValues& values);

    /// Rows m of Y with int (projected div u)^2 = |Y u|^2.
    const std::array<Row, 4>& rows() const { return rows_; }
    /// Projected volumetric strain [-] at the point x [m] where Y u is `amplitude`.
    double at(const std::array<double, 3>& x, const std::array<double, 4>& amplitude) const;

  private:
    std::array<double, 4> functions(const std::array<double, 3>& x) const;
    void solve_lower(std::array<double, 4>& b) const {
        for (int m = 0; m < 4; ++m) {
            for (int n = 0; n < m; ++n) b[m] -= mass_factor_[m][n] * b[n];
            b[m] /= mass_factor_[m][m];
        }
    }

    std::array<double, 3> centre_{};
    double size_ = 0;
    std::array<std::array<double, 4>, 4> mass_factor_{};  // Cholesky, lower triangle
    std::array<Row, 4> rows_{};
};

/// Stiffness of an element [N/m]: int 2 G dev eps : dev eps + K (projected div u)^2. Entry
/// (a * 27 + i, b * 27 + j) for the nodes i, j and the directions a, b; symmetric.
using ElementStiffness = std::array<std::array<double, 81>, 81>;
void element_stiffness(const ElementValues& values, const Moduli& moduli, ElementStiffness& k);

}  // namespace tricontact::fem
