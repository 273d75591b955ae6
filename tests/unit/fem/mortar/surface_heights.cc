#include "fem/mortar/surface_heights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../box_mesh.h"
#include "fem/contact_surface.h"

namespace tricontact::surface_heights_test {
namespace {

using contact::Vector2;

double sphere(double x, double y) {
    return 1 - std::sqrt(1 - x * x - y * y);
}

/// n x n faces over a square about the origin, their inner corners moved; heights of corners only.
struct Surface {
    contact::ContactPoints points;
    std::vector<double> height;
};

template <class Height>
Surface surface_of(int n, double half_side, double moved, Height height, bool half = false) {
    test::BoxSpec spec{.x = test::even(-half_side, half_side, n),
                       .y = test::even(half ? 0 : -half_side, half_side, half ? n / 2 : n),
                       .z = test::even(-1, 0, 1),
                       .patch_x = 1,
                       .patch_y = 1,
                       .half_model = half};
    meshes::HexMesh mesh = test::box_mesh(spec);
    test::distort(mesh, moved);
    Surface surface{fem::contact_surface(fem::Q2Space(mesh)).points, {}};
    surface.height.assign(surface.points.size(), -1);  // what lies between corners is not used
    for (const auto& quad : surface.points.quads)
        for (int k = 0; k < 4; ++k)
            surface.height[quad[k]] = height(surface.points.x[quad[k]], surface.points.y[quad[k]]);
    return surface;
}

/// Largest error within |x|, |y| <= `within`.
template <class Height>
double worst(const Surface& surface, Height height, double within = 1) {
    const fem::SurfaceHeights smooth(surface.points, surface.height);
    double error = 0;
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        if (std::max(std::abs(surface.points.x[i]), std::abs(surface.points.y[i])) <= within)
            error = std::max(error, std::abs(smooth.at_points()[i] -
                                             height(surface.points.x[i], surface.points.y[i])));
    return error;
}

TEST(FemSurfaceHeights, QuadraticSurfacesAreExactOnAnyFaces) {
    const auto saddle = [](double x, double y) {
        return .1 + .3 * x - .2 * y + x * x / 3 - .4 * x * y - y * y / 7;
    };
    EXPECT_LT(worst(surface_of(4, .3, .03, saddle), saddle), 1e-14);
    const auto even_in_y = [](double x, double y) { return .1 * x + x * x + y * y / 3; };
    EXPECT_LT(worst(surface_of(4, .3, 0, even_in_y, true), even_in_y), 1e-14);
}

// Facets are off by h^2/8R in their middle. Within the surface the order is above 3 on faces that
// are moved about; at its edge, where corners see one side only, above 2.
TEST(FemSurfaceHeights, ASphereIsMoreThanItsFacets) {
    const Surface coarse = surface_of(6, .3, .01, sphere), fine = surface_of(12, .3, .01, sphere);
    const double facets = .1 * .1 / 8, inside = .19;
    EXPECT_LT(worst(coarse, sphere), .15 * facets);
    EXPECT_GT(std::log2(worst(coarse, sphere) / worst(fine, sphere)), 2.2);
    EXPECT_LT(worst(coarse, sphere, inside), .03 * facets);
    EXPECT_GT(std::log2(worst(coarse, sphere, inside) / worst(fine, sphere, inside)), 3);
}

TEST(FemSurfaceHeights, BetweenItsNodesTheSurfaceIsBiquadratic) {
    const Surface surface = surface_of(6, .3, .01, sphere);
    const fem::SurfaceHeights smooth(surface.points, surface.height);
    for (const Vector2 x : {Vector2{0, 0}, {.1234, -.05}, {-.29, .29}})
        EXPECT_NEAR(*smooth.at(x), sphere(x[0], x[1]), 1e-4);
    EXPECT_FALSE(smooth.at({.31, 0}));
}

}  // namespace
}  // namespace tricontact::surface_heights_test
