#include "contact/base/between_rows.h"

#include <gtest/gtest.h>

#include <vector>

namespace tricontact::between_rows_test {
namespace {

using contact::between_rows;

TEST(BetweenRows, IsTheLineThroughTheTwoNextToItAndGoesOnBeyondTheEnds) {
    const std::vector<double> x{1, 2, 4}, y{10, 30, 20};
    EXPECT_DOUBLE_EQ(between_rows(x, y, 1.25), 15);
    EXPECT_DOUBLE_EQ(between_rows(x, y, 3), 25);
    EXPECT_DOUBLE_EQ(between_rows(x, y, .5), 0);
    EXPECT_DOUBLE_EQ(between_rows(x, y, 6), 10);
}

TEST(BetweenRows, IsARowExactlyWhereItStands) {
    const std::vector<double> x{.1, .3, .7}, y{1. / 3, 2. / 7, 5. / 11};
    for (std::size_t k = 0; k < x.size(); ++k) EXPECT_EQ(between_rows(x, y, x[k]), y[k]) << k;
    EXPECT_EQ(between_rows({x.data(), 1}, {y.data(), 1}, 5), y[0]);
}

}  // namespace
}  // namespace tricontact::between_rows_test
