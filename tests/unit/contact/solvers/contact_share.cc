// Under a sphere of the contact radius 1 the gap outside is that of Hertz (Johnson 1985, eq. 3.42):
//   g ~ (r^2 - 1)^(1/2) + (r^2 - 2) arccos(1/r),
// and the parts of points in contact add up to pi, those that two contacts share to their lens.

#include "contact/solvers/contact_share.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "contact/base/special_values.h"
#include "contact/friction/friction.h"

namespace tricontact::contact_share_test {
namespace {

using contact::ContactPoints;
using contact::ContactShare;
using std::numbers::pi;

double hertz_gap(double r) {
    return r <= 1 ? 0 : std::sqrt(r * r - 1) + (r * r - 2) * std::acos(1 / r);
}

std::vector<double> shares(const ContactPoints& points, double x, double y = 0) {
    std::vector<double> pressure, gap;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double r = std::hypot(points.x[i] - x, points.y[i] - y);
        pressure.push_back(r < 1 ? 1e5 : 0);
        gap.push_back(1e-3 * hertz_gap(r));
    }
    return ContactShare(points).of(pressure, gap);
}

double area(const ContactPoints& points, const std::vector<double>& share) {
    return std::inner_product(share.begin(), share.end(), points.area.begin(), 0.);
}

ContactPoints grid_of(double n, double aspect = 1) {
    const double h = 1 / n;
    const int n_x = 2 * static_cast<int>(1.8 * n) + 1;
    const int n_y = 2 * static_cast<int>(1.8 * n / aspect) + 1;
    return ContactPoints::grid(n_x, n_y, {-(n_x / 2) * h, -(n_y / 2) * h * aspect},
                               {h, h * aspect});
}

/// Nine-node faces of the side 2/n on y >= 0, as elements have them: no grid.
ContactPoints faces_of(int n, bool is_grid) {
    const int beside = 2 * n, columns = 2 * beside + 1, rows = beside + 1;
    const double h = 1. / n;
    ContactPoints points = ContactPoints::mirrored_grid(columns, rows, -beside * h, {h, h});
    const auto simpson = [](int i) { return i % 2 == 0 ? 2. / 3 : 4. / 3; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            points.area[j * columns + i] = (j == 0 ? 1 : 2) * h * h * simpson(i) * simpson(j);
    for (int j = 0; j + 2 < rows; j += 2)
        for (int i = 0; i + 2 < columns; i += 2) {
            const auto at = [&](int k, int l) { return (j + l) * columns + i + k; };
            points.quads.push_back({at(0, 0), at(2, 0), at(2, 2), at(0, 2), at(1, 0), at(2, 1),
                                    at(1, 2), at(0, 1), at(1, 1)});
        }
    if (!is_grid) points.n_x = points.n_y = 0;
    return points;
}

// Counted by whole points the area is off by some 1 % here, and not the less by half the distance
// of points. Straight lines beside a curved edge: second order.
TEST(ContactShare, AddsUpToTheContact) {
    for (const double aspect : {1., 1.5})
        for (const double n : {8., 11.3, 16., 32.})
            for (const double x : {0., .31, .5}) {
                const ContactPoints points = grid_of(n, aspect);
                EXPECT_NEAR(area(points, shares(points, x / n, .17 / n)) / pi, 1,
                            .6 * aspect * aspect / (n * n))
                    << aspect << ' ' << n << ' ' << x;
            }
}

TEST(ContactShare, AddsUpOnElementFaces) {
    for (const bool is_grid : {true, false})
        for (const int n : {8, 12})
            for (const double x : {0., .31, .5}) {
                const ContactPoints points = faces_of(n, is_grid);
                EXPECT_NEAR(area(points, shares(points, x / n)) / pi, 1, .6 / (n * n))
                    << is_grid << ' ' << n << ' ' << x;
            }
}

TEST(ContactShare, LeastOfTwoContactsIsTheirLens) {
    for (const double w : {.2, .4}) {
        const ContactPoints points = grid_of(16);
        const std::vector<double> before = shares(points, -w), after = shares(points, w);
        std::vector<double> least(before.size());
        std::ranges::transform(before, after, least.begin(),
                               [](double a, double b) { return std::min(a, b); });
        EXPECT_NEAR(area(points, least) / pi, 2 / pi * (std::acos(w) - w * std::sqrt(1 - w * w)),
                    1e-3);
    }
}

// What is no edge of a smooth gap counts whole: points with too few gaps beside them.
TEST(ContactShare, CountsWholePointsWhereTheGapTellsNothing) {
    const ContactPoints points = ContactPoints::grid(5, 5, {-2, -2}, {1, 1});
    std::vector<double> pressure(25, 1.), gap(25, 0.);
    pressure[0] = 0;
    gap[0] = 1;
    std::vector<double> share = ContactShare(points).of(pressure, gap);
    EXPECT_EQ(share[0], 0);
    EXPECT_EQ(std::accumulate(share.begin(), share.end(), 0.), 24);
    // Unknown gaps are no gaps.
    std::fill(pressure.begin(), pressure.end(), 0);
    std::fill(gap.begin(), gap.end(), contact::infinity);
    pressure[12] = 1;
    gap[12] = 0;
    share = ContactShare(points).of(pressure, gap);
    EXPECT_EQ(share[12], 1);
    EXPECT_EQ(std::accumulate(share.begin(), share.end(), 0.), 1);
}

TEST(ContactShare, LawsJumpByTheShareAlone) {
    const std::vector<double> pressure{1e5, 1e5, 0, 0}, share{1, .25, .5, 0};
    std::vector<double> bound(4);
    const contact::Friction both{.coefficient = .4, .shear_strength = 2e5};
    contact::bounds_on_shares(*both.law(), {pressure}, share, bound);
    EXPECT_NEAR(bound[0], 2.4e5, 1e-6);
    EXPECT_NEAR(bound[1], .9e5, 1e-6);
    EXPECT_NEAR(bound[2], 1e5, 1e-6);
    EXPECT_EQ(bound[3], 0);
    const contact::Friction coulomb{.coefficient = .4};
    contact::bounds_on_shares(*coulomb.law(), {pressure}, {}, bound);
    EXPECT_EQ(bound, (std::vector<double>{.4 * 1e5, .4 * 1e5, 0, 0}));
}

}  // namespace
}  // namespace tricontact::contact_share_test
