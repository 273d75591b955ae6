#include "experiments/validation/student_sum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "statistics/estimate.h"

namespace tricontact::experiments::student_sum_test {
namespace {

// Behrens' test at 5 %, equal errors (Fisher and Yates 1963, Statistical Tables, table VI, theta =
// 45 degrees), to their three decimals.
TEST(StudentSum, OfTwoEqualErrorsIsBehrensAndFisher) {
    const double equal = std::sqrt(.5);
    for (const auto& [degrees, table] :
         {std::pair{6., 2.435}, {8., 2.292}, {12., 2.167}, {24., 2.056}})
        EXPECT_NEAR(half_width_of_sum(0, {{equal, degrees}, {equal, degrees}}), table, .0015);
}

TEST(StudentSum, IsStudentsOrNormalAlone) {
    for (const int degrees :
         {1, 2, 5, 30, 999})  // a negligible known error: integrated all the same
        EXPECT_NEAR(half_width_of_sum(1e-12, {{1, double(degrees)}}),
                    statistics::student_t(.95, degrees), 1e-4);
    EXPECT_DOUBLE_EQ(half_width_of_sum(4, {}), 2 * statistics::normal_quantile(.95));
    EXPECT_DOUBLE_EQ(half_width_of_sum(4, {{0, 1}}), 2 * statistics::normal_quantile(.95));
    EXPECT_EQ(half_width_of_sum(0, {}), 0);
    EXPECT_NEAR(half_width_of_sum(9, {{4, 1e6}}), 5 * statistics::normal_quantile(.95), 1e-9);
}

// More than two: no less than without the smallest, but for a thousandth by which putting errors
// together errs, nor more than in a plain sum.
TEST(StudentSum, OfManyErrorsLiesBetweenThoseOfFewer) {
    const double two = half_width_of_sum(1, {{2, 2}, {1, 5}}),
                 three = half_width_of_sum(1, {{2, 2}, {1, 5}, {.5, 3}});
    EXPECT_GT(three, .999 * two);
    EXPECT_LT(three, two + .5 * statistics::student_t(.95, 3));
}

}  // namespace
}  // namespace tricontact::experiments::student_sum_test
