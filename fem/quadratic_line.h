#pragma once

#include <array>
#include <cmath>

namespace tricontact::fem {

/// Quadratic shape functions of an edge of unit length with nodes at 0, 1/2, 1, and Gauss' rule of
/// three points, exact for their products: all that bricks need.
struct QuadraticLine {
    using Values = std::array<double, 3>;
    using Matrix = std::array<Values, 3>;

    /// Of the three functions at s in [-1, 1] from one end to the other, and their slopes.
    static Values values_at(double s) { return {s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2}; }
    static Values slopes_at(double s) { return {2 * s - 1, -4 * s, 2 * s + 1}; }

    std::array<double, 3> weight{5. / 18, 8. / 18, 5. / 18};
    std::array<double, 3> centred{-std::sqrt(.6), 0, std::sqrt(.6)};  ///< points on [-1, 1]
    Matrix value{}, slope{};                                          ///< at point q of function i
    Matrix mass{}, stiffness{};  ///< integrals of products, of products of slopes

    QuadraticLine() {
        for (int q = 0; q < 3; ++q) {
            value[q] = values_at(centred[q]);
            slope[q] = slopes_at(centred[q]);
        }
        for (int q = 0; q < 3; ++q)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    mass[i][j] += weight[q] * value[q][i] * value[q][j];
                    stiffness[i][j] += weight[q] * slope[q][i] * slope[q][j];
                }
    }
};

}  // namespace tricontact::fem
