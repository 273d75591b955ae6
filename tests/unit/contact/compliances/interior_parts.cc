#include "contact/compliances/interior_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tricontact::interior_parts_test {
namespace {

using contact::Interior;

/// One hexahedron whose points are at this height, with values of its own.
Interior body(double z, double value) {
    Interior one;
    one.hexes.push_back({});
    for (int i = 0; i < 27; ++i) {
        one.hexes[0].at(static_cast<std::size_t>(i)) = i;
        one.points.push_back({.1 * (i % 3), .1 * (i / 3 % 3), z});
        one.displacement.push_back({value, 2 * value, 3 * value});
        one.stress.push_back({value, 0, 0, 0, 0, 0});
    }
    one.region = {0};
    one.energy_density = {value};
    one.strain_energy = value;
    one.applied = {0, 0, -value};
    one.base_reaction = {{0, 0, value}};
    return one;
}

TEST(InteriorParts, BothBodiesKeepTheirOwnPointsAndTheSubstrateItsForces) {
    const Interior below = body(-1, 5), above = contact::as_indenter(body(1, 7));
    EXPECT_FALSE(contact::has_indenter(below));
    EXPECT_FALSE(contact::has_substrate(above));
    const Interior both = contact::joined_bodies(below, above);
    EXPECT_TRUE(contact::has_indenter(both) && contact::has_substrate(both));
    ASSERT_EQ(both.points.size(), 54u);
    EXPECT_EQ(both.region, (std::vector<std::uint8_t>{0, contact::indenter_region}));
    for (const int point : both.hexes[1])
        EXPECT_EQ(both.points[static_cast<std::size_t>(point)][2], 1);
    EXPECT_EQ(both.strain_energy, 12);
    EXPECT_EQ(both.applied[2], -5);

    const Interior part = contact::substrate_part(both);
    EXPECT_EQ(part.points, below.points);
    EXPECT_EQ(part.hexes, below.hexes);
    EXPECT_EQ(part.stress, below.stress);
    EXPECT_EQ(part.energy_density, below.energy_density);
}

TEST(InteriorParts, TheIndenterAloneMoves) {
    Interior both = contact::joined_bodies(body(-1, 5), contact::as_indenter(body(1, 7)));
    // A quarter turn about its lowest point: (x, y) goes to (-y, x), and so do displacements.
    contact::move_indenter(
        {.shift = {.01, .02}, .indentation = .003, .rotation = std::numbers::pi / 2}, both);
    for (std::size_t i = 0; i < 27; ++i) {
        EXPECT_EQ(both.displacement[i], (std::array<double, 3>{5, 10, 15}));
        EXPECT_EQ(both.stress[i][0], 5);
    }
    for (std::size_t i = 27; i < 54; ++i) {
        const auto& [x, y, z] = both.points[i];
        const auto& [u, v, w] = both.displacement[i];
        EXPECT_NEAR(x + u, .01 - (y + 14), 1e-12);
        EXPECT_NEAR(y + v, .02 + (x + 7), 1e-12);
        EXPECT_NEAR(w, 21 - .003, 1e-12);
        EXPECT_NEAR(both.stress[i][1], 7, 1e-12) << "x has become y";
        EXPECT_NEAR(both.stress[i][0], 0, 1e-12);
    }
}

TEST(InteriorParts, WhatRollsComesDownWhereItTouches) {
    constexpr double radius = 2, offset = .5;
    Interior above = contact::as_indenter(body(1, 0));
    // A point of the surface an arc of the offset from the lowest one, pressed radially.
    const double angle = offset / radius;
    above.points[0] = {radius * std::sin(angle), 0, radius * (1 - std::cos(angle))};
    const double s = std::sin(angle), c = std::cos(angle);
    above.stress[0] = {-s * s, 0, -c * c, 0, 0, s * c};  // -1 along its radius
    Interior both = contact::joined_bodies(body(-1, 5), above);
    contact::move_indenter({.offset = offset, .rolling_radius = radius}, both);
    const auto& [x, y, z] = both.points[27];
    EXPECT_NEAR(x + both.displacement[27][0], offset, 1e-12);
    EXPECT_NEAR(z + both.displacement[27][2], 0, 1e-12);
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(both.stress[27].at(k), k == 2 ? -1 : 0, 1e-12) << k;
}

}  // namespace
}  // namespace tricontact::interior_parts_test
