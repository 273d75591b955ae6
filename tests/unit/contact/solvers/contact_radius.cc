#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/solvers/contact_region.h"

namespace tricontact::contact_radius_test {
namespace {

using contact::ContactPoints;
using contact::Vector2;

// Contact radius 1, means over the cells of sqrt(1 - r^2) (1 + q r^2): what a solver finds, not
// what a formula says at the centres.
std::vector<double> pressure_on(const ContactPoints& points, const Vector2& centre, double q) {
    constexpr int fine = 24;
    std::vector<double> pressure(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < fine * fine; ++k) {
            const double dx = ((k % fine + .5) / fine - .5) * points.spacing[0];
            const double dy = ((k / fine + .5) / fine - .5) * points.spacing[1];
            const double x = points.x[i] + dx - centre[0], y = points.y[i] + dy - centre[1];
            const double s = x * x + y * y;
            if (s < 1) pressure[i] += 7e5 * std::sqrt(1 - s) * (1 + q * s) / (fine * fine);
        }
    return pressure;
}

ContactPoints grid_around(double cells_per_radius, double aspect = 1) {
    const double h = 1 / cells_per_radius;
    const int n_x = 2 * static_cast<int>(1.2 / h) + 1,
              n_y = 2 * static_cast<int>(1.2 / h / aspect) + 1;
    return ContactPoints::grid(n_x, n_y, {-(n_x / 2) * h, -(n_y / 2) * h * aspect},
                               {h, h * aspect});
}

double worst_error(double n, double q, double aspect) {
    double worst = 0;
    for (const Vector2& shift : {Vector2{0, 0}, Vector2{.5, 0}, Vector2{.31, -.17}}) {
        const auto points = grid_around(n, aspect);
        const Vector2 centre = {shift[0] / n, shift[1] / n};
        const double a = contact::contact_radius(points, pressure_on(points, centre, q), centre);
        worst = std::max(worst, std::abs(a - 1));
    }
    return worst;
}

TEST(ContactRadius, WhereverTheCellsLie) {
    for (const double aspect : {1., 1.6})
        for (const double q : {-.3, 0., .4})
            for (const double n : {5., 11.25, 22.5, 31.4})
                // the moments of a cell are taken at its centre: about 1/(12 n^2) of a^2, twice for
                // the longer cells and more for the fourth moment
                EXPECT_LT(worst_error(n, q, aspect), 1.2 * aspect * aspect / (n * n))
                    << n << ' ' << q;
}

TEST(ContactRadius, ConvergesWithSecondOrder) {
    const double coarse = worst_error(11, .2, 1), fine = worst_error(33, .2, 1);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(3), 2, .4);
}

TEST(ContactRadius, RaggedEdgesHardlyMatter) {
    const auto points = grid_around(22.5);
    auto pressure = pressure_on(points, {0, 0}, 0);
    for (std::size_t i = 0; i < pressure.size(); ++i)
        if (std::hypot(points.x[i], points.y[i]) > 1 - 1 / 22.5) pressure[i] *= i % 2 ? 1.3 : .7;
    // the outermost ring carries 3 % of the force, its errors cancel but for a tenth
    EXPECT_NEAR(contact::contact_radius(points, pressure, {0, 0}), 1, 4e-3);
}

TEST(ContactRadius, WhatIsNoSuchPressureIsCounted) {
    const auto points = ContactPoints::grid(9, 1, {-4, 0}, {1, 1});
    const std::vector<double> two_ends = {1, 0, 0, 0, 0, 0, 0, 0, 1};
    EXPECT_NEAR(contact::contact_radius(points, two_ends, {0, 0}), std::sqrt(2 / std::acos(-1.)),
                1e-15);
}

// One row of points is a line with two ends, or a radius that begins at the axis.
TEST(ContactRegion, ReachesTheEdgesOfLinesAndTheEndOfARadius) {
    ContactPoints radius = ContactPoints::grid(4, 1, {.1, 0}, {.1, .1});
    ContactPoints line = radius;
    line.line_length = 2;
    EXPECT_FALSE(reaches_edge(radius, {3, 2, 1, 0}));
    EXPECT_TRUE(reaches_edge(radius, {3, 2, 1, 1}));
    EXPECT_TRUE(reaches_edge(line, {3, 2, 1, 0}));
    EXPECT_FALSE(reaches_edge(line, {0, 2, 1, 0}));
}

}  // namespace
}  // namespace tricontact::contact_radius_test
