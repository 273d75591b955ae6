// Bodies of revolution beside an independent program: quadratic elements with pressures projected
// out, curved, up to 2.2e5 unknowns, scatter of its last meshes 1e-4 in F, 3e-4 in a, 2e-5 in p0.

#include <gtest/gtest.h>

#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::bodies_of_revolution_test {
namespace {

using namespace planar_test;

const contact::Sphere sphere(10);

/// mm, N, MPa: R = 10, E = 2 of the ball, 4 of the layer of 5 mm.
struct Case {
    double poisson, depth, force, radius, peak;
};

// 25 elements across the contact. The edge cuts an element, so that a is known to a third of a
// node's distance: 1e-3 of F, 3e-3 of a would be two nodes.
void expect(const Pressed& pressed, const Case& c) {
    EXPECT_NEAR(pressed.force / c.force, 1, 5e-4) << c.poisson << ' ' << c.depth;
    EXPECT_NEAR(pressed.radius / c.radius, 1, 3e-3) << c.poisson << ' ' << c.depth;
    EXPECT_NEAR(pressed.peak / c.peak, 1, 3e-3) << c.poisson << ' ' << c.depth;
}

Sizes sizes_for(const Case& c, int n = 32) {
    return {n, 1.3 * c.radius / n, 1.25, n / 6};
}

TEST(FemPlanarBodiesOfRevolution, HemisphereOnAHolder) {
    for (const Case& c :
         {Case{.495, .1, .38130, 1.0242, .173255}, Case{.495, 1, 14.3762, 3.3742, .59060},
          Case{.3, .1, .31530, 1.0246, .143057}, Case{.3, 1, 12.0063, 3.3867, .48900}})
        expect(press({body_of(half_disc_section(sizes_for(c), 10), Solid::of_revolution,
                              {2, c.poisson})},
                     sphere, c.depth),
               c);
}

TEST(FemPlanarBodiesOfRevolution, HemisphereOnALayer) {
    for (const Case& c :
         {Case{.495, .1, .26864, 1.0426, .117819}, Case{.495, 1, 11.4475, 3.5162, .43566},
          Case{.3, .1, .21837, 1.0367, .096793}, Case{.3, 1, 8.9953, 3.4774, .34873}})
        expect(
            press(
                {body_of(half_disc_section(sizes_for(c), 10), Solid::of_revolution, {2, c.poisson}),
                 body_of(layer_section(sizes_for(c), 60, 5), Solid::of_revolution, {4, c.poisson})},
                sphere, c.depth),
            c);
}

// The middle plane of the ball stays; depth is that of one plate.
TEST(FemPlanarBodiesOfRevolution, BallBetweenPlates) {
    for (const Case& c :
         {Case{.3, .1, .30964, 1.0185, .142175}, Case{.3, 1, 11.2588, 3.3257, .47591},
          Case{.495, .1, .36685, 1.0113, .170994}, Case{.495, 1, 12.5632, 3.2421, .55987}})
        expect(press({body_of(half_disc_section(sizes_for(c), 10), Solid::of_revolution,
                              {2, c.poisson}, Support::sliding)},
                     sphere, c.depth),
               c);
}

// Meshes whose ratio is not two: the edge lies elsewhere in its element each time. The error of the
// peak falls by the square of the size, from 5 to 40 elements across the contact.
TEST(FemPlanarBodiesOfRevolution, PeakConvergesInSecondOrder) {
    const Case c{.3, 1, 12.0063, 3.3867, .48900};
    std::vector<double> error;
    for (const int n : {8, 19, 45})
        error.push_back(std::abs(press({body_of(half_disc_section(sizes_for(c, n), 10),
                                                Solid::of_revolution, {2, c.poisson})},
                                       sphere, c.depth)
                                         .peak /
                                     c.peak -
                                 1));
    EXPECT_GT(std::log(error[0] / error[1]) / std::log(19. / 8), 1.6);
    EXPECT_GT(std::log(error[1] / error[2]) / std::log(45. / 19), 1.6);
}

// Half spacing off on the layer: mortar beside matching nodes. Pressures, not only the force.
TEST(FemPlanarBodiesOfRevolution, AMortarGivesThePressuresOfMatchingNodes) {
    const Case c{.3, .1, .21837, 1.0367, .096793};
    Sizes finer = sizes_for(c);
    finer.size *= .7;
    finer.n = 46;
    const auto ball =
        body_of(half_disc_section(sizes_for(c), 10), Solid::of_revolution, {2, c.poisson});
    const auto layer = body_of(layer_section(finer, 60, 5), Solid::of_revolution, {4, c.poisson});
    const Pressed pressed = press({ball, layer}, sphere, c.depth);
    EXPECT_FALSE(nodes_meet({ball, layer}));
    EXPECT_NEAR(pressed.force / c.force, 1, 5e-4);
    EXPECT_NEAR(pressed.radius / c.radius, 1, 3e-3);
    EXPECT_NEAR(pressed.peak / c.peak, 1, 6e-3);  // three points beside the axis, extrapolated
    const Pressed matching = press(
        {ball, body_of(layer_section(sizes_for(c), 60, 5), Solid::of_revolution, {4, c.poisson})},
        sphere, c.depth);
    for (std::size_t i = 0; i < matching.along.size(); ++i) {
        if (matching.along[i] > .8 * c.radius) break;
        EXPECT_NEAR(pressed.pressure[i + 1], matching.pressure[i], 3e-3 * c.peak) << i;
    }
}

}  // namespace
}  // namespace tricontact::bodies_of_revolution_test
