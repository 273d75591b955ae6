#include "fem/planar/sections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fem/planar/body.h"
#include "fem/planar/element.h"

namespace tricontact::sections_test {
namespace {

using namespace fem::planar;

const Sizes sizes{6, .1, 1.3, 2};

/// Area by the divergence theorem over the boundary of each element, whose edges are parabolas:
/// Simpson's rule is exact for x dz.
double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& cell : mesh.cells)
        for (int edge = 0; edge < 4; ++edge) {
            const Point &a = mesh.nodes[cell[edge]], &m = mesh.nodes[cell[4 + edge]],
                        &b = mesh.nodes[cell[(edge + 1) % 4]];
            const double at_a = -3 * a[1] + 4 * m[1] - b[1], at_b = a[1] - 4 * m[1] + 3 * b[1];
            sum += (a[0] * at_a + 4 * m[0] * (b[1] - a[1]) + b[0] * at_b) / 6;
        }
    return sum;
}

std::vector<double> touching(const Mesh& mesh) {
    std::vector<double> x;
    for (const auto& [nodes, boundary] : mesh.edges)
        if (boundary == Boundary::contact)
            for (const int node : nodes) x.push_back(mesh.nodes[node][0]);
    std::ranges::sort(x);
    x.erase(std::ranges::unique(x).begin(), x.end());
    return x;
}

// Parabolas instead of arcs: their area is off by the fourth power of the elements' angle, which
// grows to a quarter of a turn opposite to the patch of a ring: 2e-4.
TEST(FemPlanarSections, FillTheBodies) {
    using std::numbers::pi;
    EXPECT_NEAR(area(half_disc_section(sizes, 2)), pi, 1e-4);
    EXPECT_NEAR(area(disc_section(sizes, 2, .5)), pi / 2 * (4 - .25), 2e-4 * 6);
    EXPECT_NEAR(area(hole_section(sizes, 2, 5)), pi / 2 * (25 - 4), 2e-4 * 33);
    EXPECT_NEAR(area(layer_section(sizes, 4, 1.5)), 6, 1e-12);
    EXPECT_NEAR(area(block_section(sizes, 2, 3, [](double x) { return x * x / 8; })), 6 - 8. / 24,
                1e-6);
    EXPECT_NEAR(area(upside_down(half_disc_section(sizes, 2))), pi, 1e-4);
    EXPECT_NEAR(area(with_mirror_image(half_disc_section(sizes, 2))), 2 * pi, 2e-4);
}

TEST(FemPlanarSections, TouchOnTheSameNodesFromBothSides) {
    const auto ball = touching(half_disc_section(sizes, 2));
    ASSERT_EQ(ball.size(), 13u);
    for (std::size_t i = 0; i < ball.size(); ++i) EXPECT_NEAR(ball[i], .05 * i, 1e-12) << i;
    const auto layer = touching(layer_section(sizes, 4, 1.5));
    const auto disc = touching(disc_section(sizes, 2, .5));
    ASSERT_EQ(layer.size(), 13u);
    ASSERT_EQ(disc.size(), 13u);
    for (std::size_t i = 0; i < ball.size(); ++i) {
        EXPECT_NEAR(layer[i], ball[i], 1e-12) << i;
        EXPECT_NEAR(disc[i], ball[i], 1e-12) << i;
    }
    EXPECT_EQ(touching(with_mirror_image(layer_section(sizes, 4, 1.5))).size(), 25u);
}

TEST(FemPlanarSections, HaveTheirNodesOnTheTrueArc) {
    for (const Mesh& mesh : {half_disc_section(sizes, 2), disc_section(sizes, 2, .5)})
        for (const auto& [nodes, boundary] : mesh.edges) {
            if (boundary != Boundary::contact) continue;
            for (const int node : nodes)
                EXPECT_NEAR(std::hypot(mesh.nodes[node][0], 2 - mesh.nodes[node][1]), 2, 1e-12);
        }
}

TEST(FemPlanarSections, HalveAllElements) {
    const Sizes half = sizes.halved();
    EXPECT_EQ(half.n, 12);
    EXPECT_DOUBLE_EQ(half.patch(), sizes.patch());
    EXPECT_NEAR(area(half_disc_section(half, 2)), std::numbers::pi, 1e-5);
}

// Of a disc that rolls: in frames of its own points the patch is the same after a turn by whole
// elements, but for elements beside the ends of the patch, whose neighbours are of another size.
// Corners and middles of elements are not alike.
TEST(FemPlanarSections, ADiscsPatchIsTheSameAfterATurn) {
    BodyProblem problem;
    problem.mesh = with_mirror_image(pin_section({8, .1, 1.2, 3}, 2, .6));
    problem.material = {3, .4};
    problem.frame = Frame::round;
    problem.radius = 2;
    const CondensedSection disc = condense(problem);
    const std::size_t n = disc.size(), end = 2;
    ASSERT_EQ(n, 33u);
    const auto entry = [&](std::size_t d, std::size_t i, std::size_t e, std::size_t k) {
        return disc.compliance[(e * n + k) * 2 * n + d * n + i];
    };
    double whole = 0, half = 0;
    for (const std::size_t d : {0, 1})
        for (const std::size_t e : {0, 1})
            for (std::size_t i = end; i + 4 + end < n; ++i)
                for (std::size_t k = end; k + 4 + end < n; ++k) {
                    const double here = entry(d, i, e, k);
                    whole = std::max(whole, std::abs(entry(d, i + 4, e, k + 4) - here));
                    half = std::max(half, std::abs(entry(d, i + 3, e, k + 3) - here));
                }
    const double middle = entry(1, n / 2, 1, n / 2);
    EXPECT_LT(whole, 1e-5 * middle);
    EXPECT_GT(half, .1 * middle);
}

}  // namespace
}  // namespace tricontact::sections_test
