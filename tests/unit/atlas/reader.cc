#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "atlas/shipped.h"
#include "statistics/sample_sequence.h"

namespace tricontact::atlas::reader_test {
namespace {

/// In the atlas' units, the coordinates of one after those of the other.
std::vector<double> points_in(const Atlas& atlas, std::uint32_t n) {
    const auto n_axes = static_cast<int>(atlas.axes.size());
    std::vector<double> points = statistics::sample_points(n, n_axes);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Axis& axis = atlas.axes[i % atlas.axes.size()];
        points[i] = axis.from + (points[i] + 1) / 2 * (axis.to - axis.from);
    }
    return points;
}

std::vector<double> middle_of(const Atlas& atlas) {
    std::vector<double> point;
    for (const Axis& axis : atlas.axes) point.push_back((axis.from + axis.to) / 2);
    return point;
}

TEST(AtlasReader, ManyPointsAreReadAsOneByOne) {
    for (const std::string_view name : shipped_names()) {
        const Atlas& atlas = shipped(name);
        const std::size_t n_axes = atlas.axes.size();
        const std::vector<double> points = points_in(atlas, 300);
        Reader reader(atlas);
        for (const Map& map : atlas.maps) {
            const Values all = read_all(atlas, map, points);
            ASSERT_EQ(all.values.size(), 300U);
            for (std::size_t i = 0; i < 300; ++i) {
                reader.go_to(std::span(points).subspan(i * n_axes, n_axes));
                const Value one = reader.read(map);
                if (std::isnan(one.value)) {  // its bar is too long
                    EXPECT_TRUE(std::isnan(all.values[i]));
                    EXPECT_THROW(said(atlas, map, one), OutsideDomain);
                    continue;
                }
                // Some hundred terms of order 1 in another order.
                EXPECT_NEAR(all.values[i], one.value, 1e-12 * (1 + std::abs(one.value)));
                EXPECT_NEAR(all.errors[i], one.error, 1e-12 + 1e-10 * one.error);
                EXPECT_GT(one.error, 0);
            }
        }
    }
}

TEST(AtlasReader, OutsideIsRefusedByEachAxis) {
    const Atlas& atlas = shipped("sphere_half_space");
    Reader reader(atlas);
    for (std::size_t d = 0; d < atlas.axes.size(); ++d) {
        const Axis& axis = atlas.axes[d];
        const double width = axis.range.to - axis.range.from;
        for (const double bad :
             {axis.from - .01 * width, axis.to + .01 * width, std::nan(""), HUGE_VAL}) {
            std::vector<double> point = middle_of(atlas);
            point[d] = bad;
            try {
                reader.go_to(point);
                ADD_FAILURE() << axis.key << " = " << bad << " is accepted";
            } catch (const OutsideDomain& error) {
                EXPECT_EQ(std::string(error.what()).find(axis.key), 0U) << error.what();
            }
            const Values read = read_all(atlas, atlas.maps.front(), point);
            EXPECT_TRUE(std::isnan(read.values[0]) && std::isnan(read.errors[0])) << axis.key;
        }
        // Rounding at an end is none.
        std::vector<double> point = middle_of(atlas);
        point[d] = axis.to + 1e-12 * width;
        EXPECT_NO_THROW(reader.go_to(point)) << axis.key;
    }
    EXPECT_THROW(reader.go_to(std::array{.1, .2}), std::invalid_argument);
    EXPECT_THROW(read_all(atlas, atlas.maps.front(), std::array{.1, .2}), std::invalid_argument);
}

TEST(AtlasReader, ValuesThatAreNotSaidAreRefused) {
    const Atlas& atlas = shipped("sphere_half_space");
    const Map& map = atlas.maps.front();
    EXPECT_EQ(said(atlas, map, {2, .1}).value, 2);
    try {
        said(atlas, map, {std::nan(""), .1});
        ADD_FAILURE();
    } catch (const OutsideDomain& error) {
        EXPECT_NE(std::string(error.what()).find(map.quantity->key), std::string::npos);
    }
}

TEST(AtlasReader, ErrorsOfCoordinatesLengthenTheBar) {
    const Atlas& atlas = shipped("sphere_half_space");
    const Map& map = atlas.maps.front();
    const std::vector<double> point = middle_of(atlas);
    Reader reader(atlas);
    const Value plain = reader.read_with_errors(map, point, {});
    const Value blurred = reader.read_with_errors(map, point, std::array{0., 1e-2});
    EXPECT_EQ(blurred.value, plain.value);
    // Towards the middle of the axis, or away from it: to second order the same.
    std::vector<double> moved = point;
    moved[1] -= 1e-2;
    reader.go_to(moved);
    EXPECT_NEAR(blurred.error, std::hypot(plain.error, reader.read(map).value - plain.value),
                1e-12);
    const Value again = read_with_errors(atlas, map, point, std::array{0., 1e-2});
    EXPECT_EQ(again.error, blurred.error);
}

}  // namespace
}  // namespace tricontact::atlas::reader_test
