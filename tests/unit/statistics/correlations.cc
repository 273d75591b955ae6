#include "statistics/correlations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tricontact::correlations_test {
namespace {

using statistics::combined_variance;
using statistics::Correlations;

Correlations three() {
    Correlations all;
    all.add("a", "c", .5);
    all.add("b", "c", -.25);
    return all;
}

TEST(Correlations, AreThoseOfTheNamesAskedFor) {
    const auto matrix = three().of({"c", "x", "a"});
    EXPECT_EQ(matrix, (Correlations::Matrix{{1, 0, .5}, {0, 1, 0}, {.5, 0, 1}}));
    EXPECT_TRUE(three().of({"a", "b", "x"}).empty());
}

// JCGM 100:2008, eq. 16, written out: 9 + 16 + 2 . 0.5 . 3 . 4.
TEST(Correlations, AddToTheVarianceOfASum) {
    EXPECT_DOUBLE_EQ(combined_variance({3, 4}, {{1, .5}, {.5, 1}}), 37);
    EXPECT_DOUBLE_EQ(combined_variance({3, -4}, {{1, .5}, {.5, 1}}), 13);
    EXPECT_DOUBLE_EQ(combined_variance({3, 4}, {}), 25);
}

// JCGM 100:2008, 5.2.2, example: ten resistors calibrated against one standard have r = 1, and the
// error of their series is ten times that of one (1 ohm), not the root of ten; r = 1 - 1e-12 here.
TEST(Correlations, OfResistorsCalibratedTogether) {
    constexpr double r = 1 - 1e-12;
    Correlations::Matrix matrix(10, std::vector<double>(10, r));
    for (int i = 0; i < 10; ++i) matrix[i][i] = 1;
    EXPECT_NEAR(std::sqrt(combined_variance(std::vector<double>(10, .1), matrix)), 1, 1e-9);
}

TEST(Correlations, HaveATriangularRoot) {
    const auto matrix = three().of({"a", "b", "c"});
    const auto root = statistics::triangular_root(matrix, 3);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double product = 0;
            for (int k = 0; k < 3; ++k) product += root[i][k] * root[j][k];
            EXPECT_NEAR(product, matrix[i][j], 1e-15);
        }
    EXPECT_EQ(statistics::triangular_root({}, 2), (Correlations::Matrix{{1, 0}, {0, 1}}));
}

TEST(Correlations, AreRefusedWhereNoNumbersCanHaveThem) {
    Correlations all;
    all.add("a", "b", .9);
    EXPECT_THROW(all.add("b", "a", .1), std::invalid_argument);
    EXPECT_THROW(all.add("a", "a", .1), std::invalid_argument);
    EXPECT_THROW(all.add("a", "c", 1), std::invalid_argument);
    all.add("b", "c", .9);
    EXPECT_FALSE(all.is_possible({"a", "b", "c"}));  // r_ac = 0: determinant -.62
    EXPECT_TRUE(all.is_possible({"a", "b"}));
    EXPECT_THROW(statistics::triangular_root(all.of({"a", "b", "c"}), 3), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::correlations_test
