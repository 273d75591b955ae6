#include "contact/solvers/contact_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tricontact::contact_region_test {
namespace {

using contact::ContactPoints;

double hertz(double x, double y) {
    return std::sqrt(std::max(0., 1 - x * x - y * y));
}

std::vector<double> hertz_on(const ContactPoints& points) {
    std::vector<double> p;
    for (std::size_t k = 0; k < points.size(); ++k) p.push_back(hertz(points.x[k], points.y[k]));
    return p;
}

// A bilinear pressure of the same forces on points has larger moments than these forces: without
// what each function spreads, a would be short by some 2 (h/a)^2.
TEST(ContactRegionMoments, MomentsOfBilinearPressuresAreThoseOfTheirFunctions) {
    constexpr int n = 12;
    constexpr double h = .2;
    ContactPoints points = ContactPoints::grid(n + 1, n + 1, {-h * n / 2, -h * n / 2}, {h, h});
    for (std::size_t k = 0; k < points.size(); ++k)
        for (const double x : {points.x[k], points.y[k]})
            if (std::abs(std::abs(x) - h * n / 2) < h / 2) points.area[k] /= 2;
    points.bilinear = true;
    const std::vector<double> at_points = hertz_on(points);
    const double a = contact::contact_radius(points, at_points, {0, 0});
    ContactPoints cells = points;
    cells.bilinear = false;
    cells.area.assign(cells.size(), h * h);
    const double of_forces = contact::contact_radius(cells, at_points, {0, 0});
    EXPECT_NEAR(a, 1, .03);  // the root at the edge, cut by straight lines: O(h)
    EXPECT_GT(a / of_forces, 1.02);
}

// Cells: nothing is added, and nothing of what was there before changes.
TEST(ContactRegionMoments, CellsHaveTheMomentsOfTheirMiddles) {
    const ContactPoints cells = ContactPoints::grid(24, 24, {-1.15, -1.15}, {.1, .1});
    const std::vector<double> p = hertz_on(cells);
    double force = 0, second = 0, fourth = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const double s = cells.x[k] * cells.x[k] + cells.y[k] * cells.y[k];
        const double f = cells.area[k] * p[k];
        force += f, second += f * s, fourth += f * s * s;
    }
    const double m1 = second / force, m2 = fourth / force;
    const double expected = std::sqrt((7 * m1 - std::sqrt(49 * m1 * m1 - 31.5 * m2)) / 2);
    EXPECT_DOUBLE_EQ(contact::contact_radius(cells, p, {0, 0}), expected);
}

}  // namespace
}  // namespace tricontact::contact_region_test
