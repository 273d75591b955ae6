#include "fem/planar/whole_section.h"

#include <gtest/gtest.h>

#include <numbers>

#include "contact/compliances/interior_parts.h"
#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::whole_section_test {
namespace {

using namespace planar_test;

constexpr double young = 3, poisson = .3, height = 2, width = 1.5, pressure = .01, length = 4;

/// A block under the same pressure on both faces, as an indenter or as a substrate.
contact::Interior pressed_block(Solid solid, bool presses) {
    const Sizes sizes{4, width / 4, 1.3, 2};
    Mesh half = block_section(sizes, width, height, [](double) { return 0.; });
    const bool line = solid == Solid::plane_strain;
    const std::vector<CondensedSection> bodies{
        body_of(line ? with_mirror_image(half) : half, solid, {young, poisson}, Support::even)};
    const ContactGrid grid = points_on_nodes(bodies);
    PairOptions options;
    options.length = length;
    options.first_presses = presses;
    const auto pair = pair_compliance(bodies, grid, options);
    const std::vector<double> p(grid.size(), pressure);
    return *pair->interior(p, contact::TangentialField(grid.size()));
}

// Uniform compression, which quadratic elements hold exactly. In plane strain the stress along y
// is nu times that along z.
TEST(FemPlanarWholeSection, EvenPressureGivesOneStress) {
    for (const Solid solid : {Solid::plane_strain, Solid::of_revolution}) {
        const bool line = solid == Solid::plane_strain;
        const contact::Interior inside = pressed_block(solid, true);
        ASSERT_FALSE(inside.hexes.empty());
        for (const auto& s : inside.stress) {
            EXPECT_NEAR(s[2], -pressure, 1e-9);
            EXPECT_NEAR(s[0], 0, 1e-9);
            EXPECT_NEAR(s[1], line ? -poisson * pressure : 0, 1e-9);
            for (const int shear : {3, 4, 5}) EXPECT_NEAR(s[shear], 0, 1e-9);
        }
        const double volume =
            height * (line ? 2 * width * length : std::numbers::pi * width * width);
        const double modulus = young / (line ? 1 - poisson * poisson : 1);
        EXPECT_NEAR(inside.strain_energy / (volume * pressure * pressure / (2 * modulus)), 1, 1e-9);
        EXPECT_TRUE(contact::has_indenter(inside));
        EXPECT_FALSE(contact::has_substrate(inside));
    }
}

/// Volume of the hexahedra by their corners, of whose edges every second node is one.
double volume_of(const contact::Interior& inside) {
    double sum = 0;
    for (const auto& hex : inside.hexes) {
        std::array<std::array<double, 3>, 3> edge{};
        constexpr std::array<int, 3> next{1, 3, 4};
        for (int k = 0; k < 3; ++k)
            for (int d = 0; d < 3; ++d)
                edge[k][d] = inside.points[hex[next[k]]][d] - inside.points[hex[0]][d];
        sum += edge[0][0] * (edge[1][1] * edge[2][2] - edge[1][2] * edge[2][1]) +
               edge[0][1] * (edge[1][2] * edge[2][0] - edge[1][0] * edge[2][2]) +
               edge[0][2] * (edge[1][0] * edge[2][1] - edge[1][1] * edge[2][0]);
    }
    return sum;
}

// A slab of bricks: the order of their corners is right, or volumes were negative.
TEST(FemPlanarWholeSection, SlabHasTheBlocksVolume) {
    EXPECT_NEAR(volume_of(pressed_block(Solid::plane_strain, true)) / (2 * width * height * length),
                1, 1e-12);
}

// The upper face moves towards the contact: down on a body that presses. Its mean stays.
TEST(FemPlanarWholeSection, WhatPressesIsPushedTheOtherWay) {
    for (const bool presses : {true, false}) {
        const contact::Interior inside = pressed_block(Solid::plane_strain, presses);
        double lower = 0;
        for (std::size_t i = 0; i < inside.points.size(); ++i)
            if (inside.points[i][2] == 0) lower = inside.displacement[i][2];
        const double shortening = height * pressure * (1 - poisson * poisson) / young;
        EXPECT_NEAR(lower / shortening, presses ? 1 : -1, 1e-9);
    }
}

// Below the middle of Hertz' pressure on a half-plane: Johnson (1985), eq. 4.46, a = p0 = 1. Means
// of elements of a/12 at their nodes, half a contact below: 1 %.
TEST(FemPlanarWholeSection, StressesBelowALineContactAreHertz) {
    const std::vector<CondensedSection> bodies{body_of(
        layer_section({16, 1. / 12, 1.1, 24}, 200, 200), Solid::plane_strain, {young, poisson})};
    const ContactGrid grid = points_on_nodes(bodies);
    PairOptions options;
    options.halves = true;
    const auto pair = pair_compliance(bodies, grid, options);
    std::vector<double> p(grid.size(), 0);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (grid.along[i] < 1) p[i] = std::sqrt(1 - grid.along[i] * grid.along[i]);
    const auto inside = pair->interior(p, contact::TangentialField(p.size()));
    int n_compared = 0;
    for (std::size_t i = 0; i < inside->points.size(); ++i) {
        const auto [x, y, z] = inside->points[i];
        if (x != 0 || z > -.4 || z < -3) continue;
        const double root = std::sqrt(1 + z * z);
        const double across = -((1 + 2 * z * z) / root + 2 * z), down = -1 / root;
        EXPECT_NEAR(inside->stress[i][0], across, .01) << z;
        EXPECT_NEAR(inside->stress[i][2], down, .01) << z;
        EXPECT_NEAR(inside->stress[i][1], poisson * (across + down), .01) << z;
        EXPECT_NEAR(inside->stress[i][5], 0, .01) << z;
        ++n_compared;
    }
    EXPECT_GT(n_compared, 20);
}

}  // namespace
}  // namespace tricontact::whole_section_test
