// Columns of elements without end under what has a closed form.

#include "fem/block/surface_symbol.h"

#include <gtest/gtest.h>

namespace tricontact::surface_symbol_test {
namespace {

using fem::SurfaceSymbol;

fem::BlockGrid column(const contact::Material& material, double thickness, int n) {
    fem::BlockGrid grid;
    for (int k = 0; k <= n; ++k)
        grid.axes[2].planes.push_back(thickness * (static_cast<double>(k) / n - 1));
    grid.axes[2].held[0] = 7;
    grid.moduli.assign(n, fem::moduli_of(material, 1e6));
    return grid;
}

/// Displacement [m] of the four kinds of nodes under a unit traction [Pa].
std::array<std::complex<double>, 4> displaced(const SurfaceSymbol& symbol, double area,
                                              int direction) {
    constexpr std::array<double, 4> share{1. / 9, 2. / 9, 2. / 9, 4. / 9};  // Simpson
    const auto matrix = symbol.compliance(0, 0, 0);
    std::array<std::complex<double>, 4> u{};
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            u[r] += matrix[(3 * c + direction) * 12 + 3 * r + direction] * share[c] * area;
    return u;
}

// b (1 - 2 nu)/(2 G (1 - nu)) of an oedometer and b/G of simple shear, which elements have exactly.
TEST(SurfaceSymbol, UniformTractionsAreAnOedometerAndSimpleShear) {
    const contact::Material material{3e6, .3};
    const double b = 7e-3, edge_x = 1e-3, edge_y = 2e-3, shear = material.shear_modulus();
    const SurfaceSymbol symbol(column(material, b, 3), edge_x, edge_y);
    for (const auto& u : displaced(symbol, edge_x * edge_y, 2)) {
        EXPECT_NEAR(u.real() * 2 * shear * .7 / (b * .4), 1, 1e-9);
        EXPECT_NEAR(u.imag() * shear / b, 0, 1e-9);
    }
    for (const int direction : {0, 1})
        for (const auto& u : displaced(symbol, edge_x * edge_y, direction))
            EXPECT_NEAR(u.real() * shear / b, 1, 1e-9);
}

TEST(SurfaceSymbol, ComplianceIsHermitianAndPositive) {
    const SurfaceSymbol symbol(column({3e6, .5}, 7e-3, 3), 1e-3, 2e-3);
    const auto matrix = symbol.compliance(.7, -1.3, 0);
    for (int c = 0; c < 12; ++c) {
        EXPECT_GT(matrix[c * 12 + c].real(), 0);
        for (int r = 0; r < 12; ++r) EXPECT_EQ(matrix[c * 12 + r], std::conj(matrix[r * 12 + c]));
    }
}

}  // namespace
}  // namespace tricontact::surface_symbol_test
