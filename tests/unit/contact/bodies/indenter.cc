#include "contact/bodies/indenter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "contact/base/error.h"
#include "contact/case.h"
#include "contact/solvers/contact_region.h"

namespace tricontact::indenter_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Indenter, Paraboloid) {
    const contact::Paraboloid p(.04);
    EXPECT_DOUBLE_EQ(p.height(.003, .004), .025 * .025 / 80e-3 * .04);
    EXPECT_DOUBLE_EQ(p.profile_slope(.003), .075);
    EXPECT_EQ(p.outer_radius(), infinity);
    EXPECT_TRUE(std::isfinite(p.height(1e3, -1e3)));
}

TEST(Indenter, SphereIsACircle) {
    const contact::Sphere ball(.04);
    for (const double r : {0., 1e-3, .024, .0399, .04}) {
        const double h = ball.height(r * .6, -r * .8);
        EXPECT_NEAR(r * r + (.04 - h) * (.04 - h), .04 * .04, 1e-17) << r;  // ten roundings
    }
    EXPECT_EQ(ball.height(.04, .001), infinity);
    EXPECT_DOUBLE_EQ(ball.profile_slope(.024), .75);
    // R - sqrt(R^2 - r^2) itself would have no correct digit left here
    EXPECT_NEAR(ball.profile(1e-10) / (1e-20 / .08), 1, 1e-15);
}

TEST(Indenter, SlopesAreDerivatives) {
    const contact::Paraboloid paraboloid(.04);
    const contact::Sphere ball(.04);
    for (const contact::AxisymmetricIndenter* body :
         {static_cast<const contact::AxisymmetricIndenter*>(&paraboloid),
          static_cast<const contact::AxisymmetricIndenter*>(&ball)})
        for (const double r : {.001, .01, .03}) {
            const double step = 1e-5 * r;
            const double difference =
                (body->profile(r + step) - body->profile(r - step)) / (2 * step);
            // truncation 1e-10, cancellation 1e-16/1e-5
            EXPECT_NEAR(body->profile_slope(r) / difference, 1, 1e-9) << r;
        }
}

TEST(Indenter, RadiusMustBePositive) {
    for (const double radius : {0., -1., std::nan(""), infinity}) {
        EXPECT_THROW(contact::Paraboloid{radius}, contact::InputError) << radius;
        EXPECT_THROW(contact::Sphere{radius}, contact::InputError) << radius;
    }
}

TEST(Indenter, CaseMakesItsOwn) {
    contact::Case c;
    c.indenter.radius = .04;
    EXPECT_DOUBLE_EQ(c.make_axisymmetric_indenter()->profile(.024), .0072);
    c.indenter.shape = contact::Case::Shape::sphere;
    EXPECT_DOUBLE_EQ(c.make_axisymmetric_indenter()->profile(.024), .008);
}

TEST(Placement, HeightsFollowTheOffset) {
    const auto points = contact::ContactPoints::grid(3, 2, {1, 10}, {.5, 2});
    ASSERT_EQ(points.size(), 6u);
    EXPECT_EQ(points.x, (std::vector<double>{1, 1.5, 2, 1, 1.5, 2}));
    EXPECT_EQ(points.y, (std::vector<double>{10, 10, 10, 12, 12, 12}));
    EXPECT_EQ(points.area, std::vector<double>(6, 1.));
    const auto height = contact::heights_over(points, contact::Paraboloid(.5), {1.5, 12});
    EXPECT_EQ(height, (std::vector<double>{4.25, 4, 4.25, .25, 0, .25}));
}

TEST(Placement, EdgeOfTheGrid) {
    const auto points = contact::ContactPoints::grid(4, 3, {0, 0}, {1, 1});
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<double> pressure(points.size(), 0.);
        pressure[i] = 1;
        const bool inside = i == 5 || i == 6;
        EXPECT_EQ(contact::reaches_edge(points, pressure), !inside) << i;
    }
}

// Where the body ends, the contact may fill the grid; along x it may not.
TEST(Placement, EndsInYAreNoEdges) {
    auto grid = contact::ContactPoints::grid(4, 3, {0, 0}, {1, 1});
    grid.line_length = 3;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        std::vector<double> pressure(grid.size(), 0.);
        pressure[i] = 1;
        EXPECT_EQ(contact::reaches_edge(grid, pressure), i % 4 == 0 || i % 4 == 3) << i;
    }
    // Two elements side by side along x: 5 x 3 nodes, those of the columns 0 and 4 at the edge.
    contact::ContactPoints elements;
    for (int node = 0; node < 15; ++node) {
        elements.x.push_back(node % 5);
        elements.y.push_back(std::floor(node / 5));
    }
    elements.quads = {{0, 2, 12, 10, 1, 7, 11, 5, 6}, {2, 4, 14, 12, 3, 9, 13, 7, 8}};
    elements.line_length = 2;
    for (int node = 0; node < 15; ++node) {
        std::vector<double> pressure(15, 0.);
        pressure[node] = 1;
        EXPECT_EQ(contact::reaches_edge(elements, pressure), node % 5 == 0 || node % 5 == 4)
            << node;
    }
}

TEST(CaseScales, HertzByForceAndByIndentation) {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {3e6, .5};  // rigid indenter: E* = 4 MPa, E*/G* = 3/2
    c.friction.coefficient = .5;
    c.load.indentation = 4e-4;
    const auto s = contact::half_space_scales(c);
    EXPECT_NEAR(s.contact_radius, 4e-3, 1e-17);
    EXPECT_NEAR(s.normal_force, 4. / 3 * 4e6 * .2 * 8e-6, 1e-13);
    EXPECT_NEAR(s.peak_pressure, 1.5 * s.normal_force / (std::acos(-1.) * 16e-6), 1e-8);
    EXPECT_NEAR(s.unit_shift, .5 * 1.5 * 4e-4, 1e-18);
    c.load.indentation.reset();
    c.load.normal_force = s.normal_force;
    const auto t = contact::half_space_scales(c);
    EXPECT_NEAR(t.indentation / s.indentation, 1, 1e-14);
    EXPECT_NEAR(t.contact_radius / s.contact_radius, 1, 1e-14);
    EXPECT_NEAR(t.normal_force / s.normal_force, 1, 1e-14);
}

TEST(CaseScales, RollingAmplitude) {
    contact::Case::Rolling rolling;
    rolling.amplitude_ratio = .24;
    EXPECT_DOUBLE_EQ(contact::rolling_amplitude(rolling, 5e-3), 1.2e-3);
    rolling.amplitude_ratio.reset();
    rolling.amplitude = 1.1e-3;
    EXPECT_DOUBLE_EQ(contact::rolling_amplitude(rolling, 5e-3), 1.1e-3);
}

}  // namespace
}  // namespace tricontact::indenter_test
