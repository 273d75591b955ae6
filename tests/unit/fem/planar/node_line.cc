#include "fem/planar/node_line.h"

#include <gtest/gtest.h>

namespace tricontact::node_line_test {
namespace {

using namespace fem::planar;

TEST(FemPlanarNodeLine, ContinuesByElementsThatGrowByOneFactor) {
    const NodeLine line = continued(equal_elements(3, .2), 5, 1.3);
    ASSERT_EQ(line.size() % 2, 1u);
    EXPECT_DOUBLE_EQ(line[6], .6);
    EXPECT_DOUBLE_EQ(line.back(), 5);
    const auto size = [&](std::size_t e) { return line[2 * e + 2] - line[2 * e]; };
    const double factor = size(3) / size(2);
    EXPECT_GT(factor, 1);
    EXPECT_LE(factor, 1.3);
    for (std::size_t e = 3; e < line.size() / 2; ++e) {
        EXPECT_NEAR(size(e) / size(e - 1), factor, 1e-9) << e;  // rounding of the sums
        EXPECT_NEAR(line[2 * e + 1], (line[2 * e] + line[2 * e + 2]) / 2, 1e-15) << e;
    }
}

TEST(FemPlanarNodeLine, StaysWhereItEndsAndRefusesToGoBack) {
    EXPECT_EQ(continued(equal_elements(2, .5), 1, 1.2).size(), 5u);
    EXPECT_THROW(continued(equal_elements(2, .5), .9, 1.2), std::invalid_argument);
}

TEST(FemPlanarNodeLine, RunsFromZeroToOneAndBack) {
    const NodeLine unit = normalised({2, 2.5, 3, 5, 7});
    EXPECT_EQ(unit, (NodeLine{0, .1, .2, .6, 1}));
    EXPECT_EQ(reversed({0, .25, 1}), (NodeLine{0, .75, 1}));
}

}  // namespace
}  // namespace tricontact::node_line_test
