// Coefficients for CONTACT beside the formulas that it takes for half-spaces, its displacements and
// tractions being those of body 1 (Kalker 1990, eq. 1.44 and section 1.6):
//   A_xx = 1/pi ∫ (1-nu)/r + nu x^2/r^3,  A_nn = 1/pi ∫ (1-nu)/r,  A_xn = -K/pi ∫ x/r^2 = -A_nx.

#include "bem/contact_program_influence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tricontact::bem::contact_program_influence_test {
namespace {

constexpr int n = 4;
constexpr double h = 2e-4;
const contact::Material indenter{7e6, .3}, substrate{5e6, .4};

InfluenceTable half_space_table() {
    InfluenceTable table{h, n, n, {}};
    const RectangleInfluence cell({indenter, substrate}, h, h);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) table.cells.push_back(cell.at(i * h, j * h));
    return table;
}

/// Over the cell of edge 1 about the origin, seen from (x, y); Gauss's rule of three points on 8x8
/// parts, far from where the integrand is infinite.
double over_cell(double x, double y, const std::function<double(double, double)>& f) {
    constexpr int parts = 8;
    const std::array<double, 3> node{-std::sqrt(.6), 0, std::sqrt(.6)}, weight{5., 8., 5.};
    double sum = 0;
    for (int k = 0; k < parts * parts; ++k)
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) {
                const double u = -.5 + (k % parts + .5 + node[a] / 2) / parts;
                const double v = -.5 + (k / parts + .5 + node[b] / 2) / parts;
                sum += weight[a] * weight[b] * f(x - u, y - v);
            }
    return sum / (18 * 18 * parts * parts);
}

TEST(ContactProgramInfluence, IsKalkers) {
    const double g1 = indenter.shear_modulus(), g2 = substrate.shear_modulus();
    const double nu1 = indenter.poisson, nu2 = substrate.poisson;
    const double g = 2 / (1 / g1 + 1 / g2), nu = g / 2 * (nu1 / g1 + nu2 / g2),
                 k = g / 4 * ((1 - 2 * nu1) / g1 - (1 - 2 * nu2) / g2);
    const auto r = [](double x, double y) { return std::hypot(x, y); };
    std::istringstream text(contact_program_influence(half_space_table(), g, true));
    std::string line;
    for (int header = 0; header < 4; ++header) std::getline(text, line);
    EXPECT_EQ(line, " 4 4 0.2 0.2 % mx, my, dx, dy");
    for (int j = 1 - n; j < n; ++j) {
        for (int header = 0; header < 2; ++header) std::getline(text, line);
        EXPECT_EQ(line[0], '%');
        for (int i = 0; i < n; ++i) {
            int found = -1;
            double place = 0;
            std::array<double, 9> a{};
            text >> found >> place;
            for (double& value : a) text >> value;
            std::getline(text, line);
            ASSERT_EQ(found, i);
            EXPECT_NEAR(place, .2 * i, 1e-15);
            if (i == 0 && j == 0) continue;  // the integrand is infinite
            const auto integral = [&](const std::function<double(double, double)>& f) {
                return .2 / std::numbers::pi * over_cell(i, j, f);  // lengths in mm
            };
            const double nn = integral([&](double x, double y) { return (1 - nu) / r(x, y); });
            const auto along = [&](double x, double y) {
                return (1 - nu) / r(x, y) + nu * x * x / std::pow(r(x, y), 3);
            };
            const double across =
                integral([&](double x, double y) { return nu * x * y / std::pow(r(x, y), 3); });
            const double xn =
                integral([&](double x, double y) { return -k * x / std::pow(r(x, y), 2); });
            const double yn =
                integral([&](double x, double y) { return -k * y / std::pow(r(x, y), 2); });
            const std::array expected{nn,
                                      -xn,
                                      -yn,
                                      xn,
                                      integral(along),
                                      across,
                                      yn,
                                      across,
                                      integral([&](double x, double y) { return along(y, x); })};
            for (std::size_t m = 0; m < 9; ++m)
                EXPECT_NEAR(a[m], expected[m], 2e-6 * nn) << i << ' ' << j << ' ' << m;
        }
    }
    EXPECT_FALSE(text >> line);
}

// A rigid indenter on an elastic substrate: pressing draws the substrate in, so that the indenter,
// seen from it, goes outwards.
TEST(ContactProgramInfluence, PressingMovesTheIndenterOutwards) {
    InfluenceTable table{h, 2, 1, {}};
    const RectangleInfluence cell({std::nullopt, substrate}, h, h);
    table.cells = {cell.at(0, 0), cell.at(h, 0)};
    EXPECT_LT(table.at(1, 0).xz, 0);
    const std::string text = contact_program_influence(table, substrate.shear_modulus(), true);
    std::istringstream last(text.substr(text.rfind(" 1 0.2 ")));
    double value = 0, xn = 0;
    for (int k = 0; k < 6; ++k) last >> value;
    xn = value;  // after ix, x, nn, nx, ny
    EXPECT_GT(xn, 0);
}

// What the model leaves out, CONTACT is not to compute.
TEST(ContactProgramInfluence, HasNoCouplingWhereTheCaseHasNone) {
    const InfluenceTable table = half_space_table();
    EXPECT_TRUE(couples(table));
    const auto numbers = [&](bool coupled) {
        std::istringstream text(contact_program_influence(table, 1e6, coupled));
        std::vector<std::array<double, 11>> rows;
        for (std::string line; std::getline(text, line);) {
            std::istringstream row(line);
            std::array<double, 11> values{};
            std::size_t k = 0;
            while (k < values.size() && row >> values[k]) ++k;
            if (k == values.size()) rows.push_back(values);
        }
        return rows;
    };
    const auto with = numbers(true), without = numbers(false);
    ASSERT_EQ(with.size(), static_cast<std::size_t>(n * (2 * n - 1)));
    ASSERT_EQ(without.size(), with.size());
    double largest = 0;
    for (std::size_t k = 0; k < with.size(); ++k)
        for (std::size_t i = 0; i < 11; ++i) {  // ix x nn nx ny xn xx xy yn yx yy
            const bool couples = i == 3 || i == 4 || i == 5 || i == 8;
            EXPECT_EQ(without[k][i], couples ? 0 : with[k][i]);
            if (couples) largest = std::max(largest, std::abs(with[k][i]));
        }
    EXPECT_GT(largest, 0);
}

TEST(ContactProgramInfluence, TableOfAnIncompressibleHalfSpaceIsUncoupled) {
    InfluenceTable table{h, n, n, {}};
    for (const auto& [nu, coupled] : {std::pair(.4996, false), std::pair(.49, true)}) {
        const RectangleInfluence cell({std::nullopt, {5e6, nu}}, h, h);
        table.cells.clear();
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) table.cells.push_back(cell.at(i * h, j * h));
        EXPECT_EQ(couples(table), coupled) << nu;
    }
}

}  // namespace
}  // namespace tricontact::bem::contact_program_influence_test
