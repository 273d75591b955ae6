#include <gtest/gtest.h>

#include <cmath>

#include "contact/compliances/interior.h"

namespace tricontact::contact::subsurface_test {
namespace {

/// x -2 .. 2, y -1 .. 1, z -3 .. 0; the tension along x at a point tells where it is.
Interior block() {
    Interior in;
    in.axes = {std::vector<double>{-2, -1, 0, 1, 2}, {-1, 0, 1}, {-3, -2, -1, 0}};
    for (int i = 0; i < 60; ++i) in.stress.push_back({1. + i, 0, 0, 0, 0, 0});
    return in;
}

Interior as_points(const Interior& grid) {
    Interior in;
    for (std::size_t i = grid.size(); i-- > 0;) {  // in another order
        in.points.push_back(grid.position(i));
        in.stress.push_back(grid.stress[i]);
    }
    return in;
}

void expect_block(const Subsurface& s) {
    EXPECT_EQ(s.phase, 2.25);
    EXPECT_EQ(s.peak_von_mises, 100);
    EXPECT_EQ(s.peak_position, (std::array<double, 3>{-1.1, .8, -2}));  // from the indenter
    ASSERT_EQ(s.x.size(), 5U);
    EXPECT_NEAR(s.x[1], -1.1, 1e-15);
    EXPECT_EQ(s.axis(), 2U);
    ASSERT_EQ(s.z, (std::vector<double>{-3, -2, -1, 0}));
    // y = 0 is nearest to 0.2.
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 5; ++i) EXPECT_EQ(s.at(i, k)[0], 1 + i + 5 + 15 * k);
}

TEST(Subsurface, FindsThePeakAndTheSectionBelowTheIndenter) {
    Interior in = block();
    in.stress[1 + 10 + 15] = {0, 0, -100, 0, 0, 0};  // x = -1, y = 1, z = -2
    expect_block(subsurface_of(in, 2.25, {.1, .2}));
    expect_block(subsurface_of(as_points(in), 2.25, {.1, .2}));
}

TEST(Subsurface, PointsThatAreNoGridHaveAPeakOnly) {
    Interior in = as_points(block());
    in.points[52][2] = -.5;  // of the plane y = 0
    const auto s = subsurface_of(in, 0, {0, 0});
    EXPECT_EQ(s.peak_von_mises, 60);
    EXPECT_TRUE(s.x.empty());
    EXPECT_TRUE(s.stress.empty());
}

TEST(Subsurface, MeasuresOfStress) {
    EXPECT_DOUBLE_EQ(von_mises({-3, 0, 0, 0, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(von_mises({0, 0, 0, 0, -2, 0}), 2 * std::sqrt(3.));
    EXPECT_EQ(von_mises({-4, -4, -4, 0, 0, 0}), 0);
    EXPECT_EQ(mean_pressure({-4, -5, -6, 1, 1, 1}), 5);
}

}  // namespace
}  // namespace tricontact::contact::subsurface_test
