#include "fem/planar/pair.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::planar_pair_test {
namespace {

using namespace planar_test;
using Kind = contact::NormalControl::Kind;

/// Blocks of one width, whose whole faces touch.
Mesh block(int n, double height, double profile = 0) {
    return block_section({n, 1. / n, 1.2, 1}, 1, height, [=](double) { return profile; });
}
Mesh ground(int n, double thickness) {
    return layer_section({n, 1. / n, 1.2, 1}, 1, thickness);
}

// A uniform pressure on both: the columns shorten by p H (1 - nu^2)/E in plane strain, p H/E as
// bodies of revolution, everywhere, whatever their nodes. To rounding.
TEST(FemPlanarPair, PressuresAreUniformBetweenMeshesThatDoNotMatch) {
    for (const Solid solid : {Solid::plane_strain, Solid::of_revolution}) {
        const contact::Material upper{2, .3}, lower{5, .4};
        const std::vector<CondensedSection> bodies{
            body_of(block(7, 1.3), solid, upper, Support::sliding),
            body_of(ground(5, .8), solid, lower, Support::sliding)};
        ASSERT_FALSE(nodes_meet(bodies));
        const ContactGrid grid = grid_between(bodies);
        EXPECT_EQ(grid.size(), 11u);
        PairOptions options;
        options.halves = solid == Solid::plane_strain;
        const auto part = [&](const contact::Material& m) {
            return options.halves ? m.plane_compliance() : 1 / m.young;
        };
        const double d = 1e-3, p = d / (1.3 * part(upper) + .8 * part(lower));
        const Pressed pressed = press(bodies, grid, options, std::vector<double>(grid.size(), 0),
                                      {Kind::indentation, d});
        for (const double pressure : pressed.pressure) EXPECT_NEAR(pressure / p, 1, 1e-10);
        const double area = options.halves ? 2 : std::numbers::pi;
        EXPECT_NEAR(pressed.force / (p * area), 1, 1e-10);
    }
}

const Sizes coarse{16, .085, 1.25, 2};
const contact::Sphere sphere(10);

// Symmetry: the plane between both does not move. To the tolerance of the solver.
TEST(FemPlanarPair, TwoEqualHemispheresPressAsOneOnARigidPlane) {
    const Mesh mesh = half_disc_section(coarse, 10);
    const contact::Material rubber{2, .495};
    const auto upper = body_of(mesh, Solid::of_revolution, rubber);
    const auto lower = body_of(upside_down(mesh), Solid::of_revolution, rubber);
    const Pressed one = press({upper}, sphere, .1);
    const ContactGrid grid = grid_between({upper, lower});
    std::vector<double> height;
    for (const double r : grid.along) height.push_back(2 * sphere.height(r, 0));
    const Pressed two = press({upper, lower}, grid, {}, height, {Kind::indentation, .2});
    EXPECT_NEAR(two.force / one.force, 1, 1e-6);
    EXPECT_NEAR(two.radius / one.radius, 1, 1e-6);
    EXPECT_NEAR(two.peak / one.peak, 1, 1e-6);
}

// Of one nu both deform in proportion to 1/E, and so as one of 2 E1 E2/(E1 + E2) on a rigid plane.
TEST(FemPlanarPair, TwoUnlikeHemispheresPressAsOneOfTheirHarmonicMean) {
    const Mesh mesh = half_disc_section(coarse, 10);
    const auto upper = body_of(mesh, Solid::of_revolution, {2, .3});
    const auto lower = body_of(upside_down(mesh), Solid::of_revolution, {6, .3});
    const Pressed one = press({body_of(mesh, Solid::of_revolution, {3, .3})}, sphere, .1);
    const ContactGrid grid = grid_between({upper, lower});
    std::vector<double> height;
    for (const double r : grid.along) height.push_back(2 * sphere.height(r, 0));
    const Pressed two = press({upper, lower}, grid, {}, height, {Kind::indentation, .2});
    EXPECT_NEAR(two.force / one.force, 1, 1e-6);
    EXPECT_NEAR(two.radius / one.radius, 1, 1e-6);
    EXPECT_NEAR(two.peak / one.peak, 1, 1e-6);
}

// Equal bodies do not couple: pressures move points of both alike along the surface.
TEST(FemPlanarPair, EqualBodiesDoNotCoupleAndUnequalOnesDo) {
    const Mesh mesh = half_disc_section(coarse, 10);
    const auto upper = body_of(mesh, Solid::of_revolution, {2, .3});
    const auto lower = body_of(upside_down(mesh), Solid::of_revolution, {2, .3});
    const auto coupling = [](const std::vector<CondensedSection>& bodies) {
        const auto pair = pair_compliance(bodies, grid_between(bodies), {});
        const std::size_t n = pair->points().size();
        double most = 0, scale = 0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < n; ++k) {
                most = std::max(most, std::abs(pair->dense()[(2 * n + k) * 3 * n + i]));
                scale = std::max(scale, std::abs(pair->dense()[(2 * n + k) * 3 * n + 2 * n + i]));
            }
        return most / scale;
    };
    EXPECT_LT(coupling({upper, lower}), 1e-10);
    EXPECT_GT(coupling({upper}), 1e-2);
}

// Numbers of an independent program: F and p0 are its converged values, F/E = .31530/2. This mesh
// has 12 elements across the contact: .1 % in F, .3 % in p0 and a, of which most is the edge that
// cuts an element.
TEST(FemPlanarPair, AHemisphereOnItsHolderIsStifferThanHertz) {
    const auto body = body_of(half_disc_section(coarse, 10), Solid::of_revolution, {2, .3});
    const Pressed pressed = press({body}, sphere, .1);
    EXPECT_NEAR(pressed.force / .31530, 1, 1e-3);
    EXPECT_NEAR(pressed.radius / 1.0246, 1, 4e-3);
    EXPECT_NEAR(pressed.peak / .143057, 1, 3e-3);
}

TEST(FemPlanarPair, AMortarKeepsForceAndMoment) {
    const std::vector<CondensedSection> bodies{
        body_of(block(7, 1.3), Solid::plane_strain, {2, .3}),
        body_of(ground(5, .8), Solid::plane_strain, {2, .3})};
    const ContactGrid grid = mortar(bodies);
    const auto pressure = [](int point) { return 1 + std::sin(5. * point); };
    double force = 0;
    for (std::size_t i = 0; i < grid.size(); ++i)
        force += pressure(static_cast<int>(i)) * grid.area[i];
    std::vector<double> moments;
    for (std::size_t b = 0; b < 2; ++b) {
        double of_body = 0, moment = 0;
        for (const auto& [node, point, value] : grid.transfer[b]) {
            of_body += value * pressure(point);
            moment += value * pressure(point) * bodies[b].along[node];
        }
        EXPECT_NEAR(of_body / force, 1, 1e-12);
        moments.push_back(moment);
    }
    EXPECT_NEAR(moments[1] / moments[0], 1, 1e-12);
}

// The support carries what presses, in every body: to rounding, K/G being 1e6 in one.
TEST(FemPlanarPair, SupportsCarryTheForce) {
    const std::vector<CondensedSection> bodies{
        body_of(half_disc_section(coarse, 10), Solid::of_revolution, {2, .5}),
        body_of(layer_section(coarse, 60, 5), Solid::of_revolution, {4, .3}, Support::sliding)};
    const auto pair = pair_compliance(bodies, grid_between(bodies), {});
    const std::size_t n = pair->points().size();
    std::vector<double> p(n, 1);
    contact::TangentialField t(n);
    double force = 0;
    for (std::size_t i = 0; i < n; ++i) {
        t.x[i] = p[i] = static_cast<double>(n - i);
        force += p[i] * pair->points().area[i];
    }
    const auto missing = pair->missing_reaction(p, t);
    ASSERT_TRUE(missing);
    EXPECT_LT(std::abs((*missing)[2]) / force, 1e-8);
    EXPECT_NE((*missing)[2], 0);
}

TEST(FemPlanarPair, RefusesSurfacesThatDoNotFaceEachOther) {
    CondensedSection first = body_of(block(4, 1), Solid::plane_strain, {2, .3}), second = first;
    for (double& x : second.along) x += 3;
    EXPECT_THROW(grid_between({first, second}), contact::InputError);
    Mesh without = block(4, 1);
    for (auto& edge : without.edges)
        if (edge.boundary == Boundary::contact) edge.boundary = Boundary::free;
    EXPECT_THROW(body_of(without, Solid::plane_strain, {2, .3}), contact::InputError);
}

}  // namespace
}  // namespace tricontact::planar_pair_test
