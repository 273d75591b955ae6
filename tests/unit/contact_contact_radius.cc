#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/contact_radius.h"

namespace tricontact {
namespace {

using contact::ContactPoints;
using contact::Vector2;

// Contact radius 1, Hertz' pressure 1 - r^2 under the root, sampled at the cells' centres.
std::vector<double> hertz(const ContactPoints& points, const Vector2& centre) {
    std::vector<double> pressure;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double r = std::hypot(points.x[i] - centre[0], points.y[i] - centre[1]);
        pressure.push_back(r < 1 ? 7e5 * std::sqrt(1 - r * r) : 0);
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

TEST(ContactRadius, ExactForHertzWhereverTheCellsLie) {
    for (const double aspect : {1., 1.6})
        for (const double n : {22.5, 23., 31.4})
            for (const Vector2& shift : {Vector2{0, 0}, Vector2{.5, 0}, Vector2{.31, -.17}}) {
                const auto points = grid_around(n, aspect);
                const Vector2 centre = {shift[0] / n, shift[1] / n};
                // p^2 is linear in r^2: the fit has it exactly, but for rounding
                EXPECT_NEAR(contact::contact_radius(points, hertz(points, centre), centre), 1,
                            1e-10)
                    << n << ' ' << shift[0];
            }
}

// A pressure as it comes from cells: exact sphere, p ~ sqrt(1 - r^2) (1 + q r^2), and the values of
// the cells next to the edge wrong by half, which the fit leaves out.
TEST(ContactRadius, SecondFactorsAndRaggedEdgesDoNotMatter) {
    for (const double n : {22.5, 33.3, 45.})
        for (const Vector2& shift : {Vector2{0, 0}, Vector2{.5, .5}, Vector2{.31, -.17}}) {
            const auto points = grid_around(n);
            const Vector2 centre = {shift[0] / n, shift[1] / n};
            auto pressure = hertz(points, centre);
            for (std::size_t i = 0; i < pressure.size(); ++i) {
                const double r = std::hypot(points.x[i] - centre[0], points.y[i] - centre[1]);
                pressure[i] *= 1 + .2 * r * r;
                if (r > 1 - 1 / n) pressure[i] *= i % 2 ? 1.5 : .5;
            }
            // p^2 (1 + q r^2)^2 is a cubic in r^2: exact again
            EXPECT_NEAR(contact::contact_radius(points, pressure, centre), 1, 1e-9) << n;
        }
}

// Worst error over nine positions of the centre, for p^2 = (1 - r^2) exp(r^2/2), no polynomial, on
// which area-weighted fits from different cells differ.
double worst_error(double n) {
    double worst = 0;
    for (const double x : {0., .2, .5})
        for (const double y : {0., .3, .45}) {
            const auto points = grid_around(n);
            const Vector2 centre = {x / n, y / n};
            auto pressure = hertz(points, centre);
            for (std::size_t i = 0; i < pressure.size(); ++i) {
                const double r = std::hypot(points.x[i] - centre[0], points.y[i] - centre[1]);
                pressure[i] *= std::exp(r * r / 4);
            }
            const double a = contact::contact_radius(points, pressure, centre);
            worst = std::max(worst, std::abs(a - 1));
        }
    return worst;
}

TEST(ContactRadius, PositionOfTheCellsHardlyMatters) {
    // The cubic leaves out -.018 s^4 of p^2; extrapolated from s < .81 to 1: about 3e-4, whatever
    // the cells. Of 45 cells across, counting would miss several times as much.
    for (const double n : {11.25, 22.5, 45.}) EXPECT_LT(worst_error(n), 4e-4) << n;
}

TEST(ContactRadius, TooFewCellsAreCounted) {
    const auto points = ContactPoints::grid(5, 5, {-2, -2}, {1, 1});
    std::vector<double> pressure(25, 0.);
    for (const int i : {11, 12, 13, 7, 17}) pressure[i] = 1;  // a cross of five unit cells
    EXPECT_NEAR(contact::contact_radius(points, pressure, {0, 0}), std::sqrt(5 / std::acos(-1.)),
                1e-15);
}

}  // namespace
}  // namespace tricontact
