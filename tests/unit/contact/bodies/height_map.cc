// Height maps between their nodes, and as bodies.

#include "contact/bodies/height_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "contact/base/error.h"

namespace tricontact::height_map_test {
namespace {

using contact::HeightField;
using contact::HeightMap;

constexpr double infinity = std::numeric_limits<double>::infinity();

HeightMap bilinear_map() {  // z = 1 + 2 x - 3 y + 4 x y on nodes at multiples of 0.5 and 0.25
    HeightMap map{4, 5, {.5, .25}, {}};
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 4; ++i) {
            const double x = .5 * i, y = .25 * j;
            map.height.push_back(1 + 2 * x - 3 * y + 4 * x * y);
        }
    return map;
}

HeightMap random_map(int n_x, int n_y, double spacing) {
    std::mt19937_64 bits(3);
    HeightMap map{n_x, n_y, {spacing, spacing}, {}};
    for (int k = 0; k < n_x * n_y; ++k)
        map.height.push_back(std::ldexp(static_cast<double>(bits() >> 11), -53) * spacing);
    return map;
}

TEST(HeightField, IsExactForBilinearHeights) {
    const HeightField field(bilinear_map());
    for (const auto& [x, y] : {std::pair(.5, .25), {.1, .2}, {.7, .9}, {1.4, .01}}) {
        EXPECT_NEAR(field.at(x, y).height, 1 + 2 * x - 3 * y + 4 * x * y, 1e-13) << x << ' ' << y;
        EXPECT_NEAR(field.at(x, y).slope[0], 2 + 4 * y, 1e-12);
        EXPECT_NEAR(field.at(x, y).slope[1], -3 + 4 * x, 1e-12);
    }
}

TEST(HeightField, RepeatsItself) {
    const HeightMap map = random_map(6, 9, .3);
    const HeightField field(map);
    for (const int p : {-2, 0, 3})
        for (int j = 0; j < 9; ++j)
            for (int i = 0; i < 6; ++i)
                EXPECT_EQ(field.at((i + 6 * p) * .3, (j - 9 * p) * .3).height, map.at(i, j));
    // half way over the seam
    EXPECT_NEAR(field.at(-.15, 0).height, (map.at(5, 0) + map.at(0, 0)) / 2, 1e-16);
}

TEST(HeightField, RefusesWhatIsNoMap) {
    EXPECT_THROW(HeightField({1, 5, {1, 1}, std::vector<double>(5)}), contact::InputError);
    EXPECT_THROW(HeightField({2, 2, {1, 1}, std::vector<double>(5)}), contact::InputError);
    EXPECT_THROW(HeightField({2, 2, {1, 0}, std::vector<double>(4)}), contact::InputError);
    EXPECT_THROW(HeightField({2, 2, {1, 1}, {0, 0, 0, std::nan("")}}), contact::InputError);
}

TEST(HeightMap, MeanSquares) {
    const HeightMap map{2, 3, {.5, 2}, {0, 1, 0, 1, 0, 1}};
    EXPECT_DOUBLE_EQ(rms_height(map), .5);
    EXPECT_DOUBLE_EQ(rms_slope(map), 2);  // along x alone
}

TEST(MappedIndenter, LiesWithItsMiddleNodeAtTheOriginAndEnds) {
    const HeightMap map = random_map(6, 5, .1);
    const double lowest = *std::ranges::min_element(map.height);
    const contact::MappedIndenter body(map);
    EXPECT_EQ(body.height(0, 0), map.at(3, 2) - lowest);
    EXPECT_EQ(body.height(-.3, .2), map.at(0, 4) - lowest);
    EXPECT_EQ(body.height(.2001, 0), infinity);
    EXPECT_EQ(body.height(0, -.2001), infinity);
}

TEST(RoughIndenter, RepeatsTheMapFromItsMiddle) {
    const HeightMap map = random_map(6, 5, .1);
    const contact::MappedIndenter once(map);
    const contact::RoughIndenter always(std::make_unique<contact::Plane>(), from_middle(map));
    for (const double x : {-.3, -.1, 0., .2})
        for (const double y : {-.2, 0., .1}) {
            EXPECT_EQ(once.height(x, y), always.height(x, y));
            EXPECT_NEAR(always.height(x + .6, y - .5), once.height(x, y), 1e-15);
        }
}

// The sum's lowest node need not be the roughness' own.
TEST(RoughIndenter, CountsFromTheLowestOfBodyAndMap) {
    const HeightMap map = random_map(64, 64, .01);
    for (const double radius : {1e-3, 1., 1e3}) {
        const contact::RoughIndenter ball(std::make_unique<contact::Paraboloid>(radius), map);
        double lowest = infinity;
        for (int j = -32; j <= 32; ++j)
            for (int i = -32; i <= 32; ++i)
                lowest = std::min(lowest, ball.height(i * .01, j * .01));
        EXPECT_NEAR(lowest, 0, 1e-15) << radius;
    }
}

}  // namespace
}  // namespace tricontact::height_map_test
