#include "fem/mortar/surface_gap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../box_mesh.h"
#include "contact/base/special_values.h"
#include "fem/contact_surface.h"

namespace tricontact::surface_gap_test {
namespace {

using contact::ContactPoints;

/// The top of a box, its nodes lifted to a paraboloid about (x_0, 0).
struct Bowl {
    ContactPoints points;
    std::vector<double> height;

    Bowl(int n, double radius, double x_0, double offset) {
        const test::BoxSpec spec{.x = test::even(-.3, .3, n),
                                 .y = test::even(-.3, .3, n),
                                 .z = test::even(-1, 0, 1),
                                 .patch_x = 1,
                                 .patch_y = 1};
        points = fem::contact_surface(fem::Q2Space(test::box_mesh(spec))).points;
        for (std::size_t i = 0; i < points.size(); ++i)
            height.push_back(offset + (std::pow(points.x[i] - x_0, 2) + std::pow(points.y[i], 2)) /
                                          2 / radius);
    }
};

// The mean of r^2/2R over a bilinear function is h^2/6R more than at its point, along both axes
// together; a uniform distance between the bodies is let down.
TEST(FemSurfaceGap, IsTheMeanOfTheDistanceOfBothSurfaces) {
    const Bowl above(5, 2, .02, .7), below(4, 3, .02, .1);
    const ContactPoints grid = fem::pressure_grid({{-.3, -.3}, {.3, .3}}, .1, false);
    const fem::SurfaceHeights upper(above.points, above.height), lower(below.points, below.height);
    fem::SurfaceGap gap(grid);
    gap.add(upper, fem::transfer_to(above.points, grid), 1);
    gap.add(lower, fem::transfer_to(below.points, grid), -1);
    const auto least = gap.let_down(upper, &lower);
    const double curvature = 1. / 2 - 1. / 3, h = grid.spacing[0];
    EXPECT_NEAR(least.height, .6, curvature * std::pow(h / 16, 2));  // the lattice of 1/8
    EXPECT_NEAR(least.place[0], .02, h / 8);
    for (const double x : {-.2, 0., .1}) {
        const double expected =
            curvature * ((x - .02) * (x - .02) / 2 + h * h / 6) + .6 - least.height;
        EXPECT_NEAR(gap.height(x, 0), expected, 1e-12);
    }
    EXPECT_EQ(gap.height(.36, 0), contact::infinity);
    EXPECT_NEAR(gap.slope(.1, 0)[0], curvature * .08, 1e-12);
}

TEST(FemSurfaceGap, OverAPlaneTheIndenterTouchesAtItsLowestPoint) {
    const Bowl above(6, 2, 0, .5);
    const ContactPoints grid = fem::pressure_grid({{-.3, -.3}, {.3, .3}}, .1, false);
    const fem::SurfaceHeights upper(above.points, above.height);
    fem::SurfaceGap gap(grid);
    gap.add(upper, fem::transfer_to(above.points, grid), 1);
    EXPECT_NEAR(gap.let_down(upper, nullptr).height, .5, 1e-14);
}

}  // namespace
}  // namespace tricontact::surface_gap_test
