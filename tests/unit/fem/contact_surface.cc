#include "fem/contact_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "contact/base/error.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::contact_surface_test {
namespace {

using fem::ContactSurface;
using fem::Q2Space;

// Patch of 4 x 2 elements of 1 x .5 in a larger block.
test::BoxSpec block() {
    return {{-4, -2, -1, 0, 1, 2, 5}, {-2, -.5, 0, .5, 3}, {-2, -1, 0}, 2, .5};
}

ContactSurface surface_of(const test::BoxSpec& spec) {
    return contact_surface(Q2Space(test::box_mesh(spec)));
}

double sum(const std::vector<double>& v) {
    return std::accumulate(v.begin(), v.end(), 0.);
}

// Integral of the product of two functions given at the nodes.
double integrate(const ContactSurface& surface, const std::vector<double>& f,
                 const std::vector<double>& g) {
    double total = 0;
    const auto& mass = surface.mass;
    for (int c = 0; c < mass.n; ++c)
        for (auto k = mass.column_start[c]; k < mass.column_start[c + 1]; ++k) {
            const auto r = mass.row[k];
            total += mass.value[k] * (r == c ? f[r] * g[c] : f[r] * g[c] + f[c] * g[r]);
        }
    return total;
}

TEST(FemContactSurface, RegularPatchIsAGrid) {
    const auto surface = surface_of(block());
    const auto& points = surface.points;
    ASSERT_EQ(points.n_x, 9);
    ASSERT_EQ(points.n_y, 5);
    EXPECT_EQ(points.first, (contact::Vector2{-2, -.5}));
    EXPECT_EQ(points.spacing, (contact::Vector2{.5, .25}));
    EXPECT_FALSE(points.mirrored);
    const auto grid = contact::ContactPoints::grid(9, 5, points.first, points.spacing);
    EXPECT_EQ(points.x, grid.x);
    EXPECT_EQ(points.y, grid.y);
}

TEST(FemContactSurface, PositionsAreThoseOfTheNodes) {
    const Q2Space space(test::box_mesh(block()));
    const auto surface = contact_surface(space);
    for (std::size_t i = 0; i < surface.nodes.size(); ++i) {
        EXPECT_EQ(surface.points.x[i], space.nodes[surface.nodes[i]][0]);
        EXPECT_EQ(surface.points.y[i], space.nodes[surface.nodes[i]][1]);
    }
}

// Simpson's weights: the row sums of a rectangle's Q2 mass.
TEST(FemContactSurface, AreasAreSimpsonsWeights) {
    const auto surface = surface_of(block());
    const auto& points = surface.points;
    const auto simpson = [](int i, int n) {
        return (i % 2 ? 4 : i == 0 || i == n - 1 ? 1 : 2) / 6.;
    };
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 9; ++i)
            EXPECT_NEAR(points.area[j * 9 + i], simpson(i, 9) * 1 * simpson(j, 5) * .5, 1e-15);
}

TEST(FemContactSurface, MassIntegratesProductsOfQuadratics) {
    const auto surface = surface_of(block());
    std::vector<double> f, g;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const double x = surface.points.x[i], y = surface.points.y[i];
        f.push_back(1 + x * x + y);
        g.push_back(y * y - x);
    }
    // Integral of y^2 - x + x^2 y^2 - x^3 + y^3 - x y over |x| < 2, |y| < 1/2: even terms.
    const double y2 = 1. / 12, x2 = 16. / 3;
    EXPECT_NEAR(integrate(surface, f, g), 4 * y2 + x2 * y2, 1e-13);
    EXPECT_EQ(surface.mass.n, 45);
}

TEST(FemContactSurface, HalfModelCountsBothSides) {
    auto spec = block();
    spec.y = {0, .5, 1, 3};
    spec.patch_y = 1;
    spec.half_model = true;
    const auto surface = surface_of(spec);
    EXPECT_TRUE(surface.points.mirrored);
    EXPECT_EQ(surface.points.n_y, 5);
    EXPECT_NEAR(sum(surface.points.area), 4 * 2, 1e-14);
    const std::vector<double> one(surface.points.size(), 1.);
    EXPECT_NEAR(integrate(surface, one, one), 4, 1e-14);  // the mass is of the half
}

TEST(FemContactSurface, QuadrilateralsJoinNeighbours) {
    const auto surface = surface_of(block());
    const auto& points = surface.points;
    ASSERT_EQ(points.quads.size(), 8u);
    for (const auto& quad : points.quads) {
        // Counterclockwise from above, mid nodes between their corners, the centre in the middle.
        const auto x = [&](int i) { return Eigen::Vector2d(points.x[quad[i]], points.y[quad[i]]); };
        const Eigen::Vector2d u = x(1) - x(0), v = x(3) - x(0);
        EXPECT_NEAR(u[0] * v[1] - u[1] * v[0], .5, 1e-14);
        for (int e = 0; e < 4; ++e) EXPECT_EQ(x(4 + e), (x(e) + x((e + 1) % 4)) / 2);
        EXPECT_EQ(x(8), (x(0) + x(2)) / 2);
    }
}

TEST(FemContactSurface, UnevenOrRaggedPatchesAreNoGrid) {
    auto uneven = block();
    uneven.x = {-4, -2, -1.1, 0, 1, 2, 5};
    const auto surface = surface_of(uneven);
    EXPECT_EQ(surface.points.n_x, 0);
    EXPECT_EQ(surface.points.n_y, 0);
    EXPECT_NEAR(sum(surface.points.area), 4, 1e-14);
    for (std::size_t i = 1; i < surface.points.size(); ++i) {
        const auto place = [&](std::size_t k) {
            return std::pair(surface.points.y[k], surface.points.x[k]);
        };
        EXPECT_LT(place(i - 1), place(i));
    }
    auto mesh = test::box_mesh(block());
    for (auto& face : mesh.faces)
        if (face.boundary == meshes::Boundary::contact) {
            face.boundary = meshes::Boundary::free_top;  // a corner is missing
            break;
        }
    EXPECT_EQ(contact_surface(Q2Space(mesh)).points.n_x, 0);
}

TEST(FemContactSurface, RoundedCoordinatesStillMakeAGrid) {
    auto mesh = test::box_mesh(block());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) mesh.nodes[i][0] += 1e-9 * std::sin(9. * i);
    const auto surface = contact_surface(Q2Space(mesh));
    EXPECT_EQ(surface.points.n_x, 9);
    EXPECT_EQ(surface.points.n_y, 5);
    for (int j = 0; j < 5; ++j) EXPECT_EQ(surface.points.x[j * 9 + 4], surface.points.x[4]);
}

TEST(FemContactSurface, NoContactIsRefused) {
    auto spec = block();
    spec.patch_x = 0;
    EXPECT_THROW(surface_of(spec), contact::InputError);
}

}  // namespace
}  // namespace tricontact::contact_surface_test
