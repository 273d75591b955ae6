#include "statistics/sample_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "statistics/sparse_polynomial.h"

namespace tricontact::statistics::sample_sequence_test {
namespace {

// Where the sequence was before it was mapped: u = acos(x)/pi.
double place(double x) {
    return std::acos(x) / std::numbers::pi;
}

TEST(SampleSequence, LongerOnesBeginWithShorterOnes) {
    for (int n_variables = 1; n_variables <= most_variables; ++n_variables) {
        const auto points = sample_points(300, n_variables);
        const auto fewer = sample_points(100, n_variables);
        ASSERT_EQ(points.size(), 300U * static_cast<std::size_t>(n_variables));
        EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), points.begin()));
        const auto stride = n_variables;
        for (const std::uint32_t i : {0U, 1U, 77U, 299U})
            EXPECT_EQ(sample_point(i, n_variables),
                      std::vector<double>(points.begin() + i * stride,
                                          points.begin() + (i + 1) * stride));
    }
}

// Later variables do not change the ones before.
TEST(SampleSequence, VariablesAreNested) {
    const auto three = sample_point(41, 3), six = sample_point(41, 6);
    EXPECT_TRUE(std::equal(three.begin(), three.end(), six.begin()));
}

// Each variable of a Sobol sequence is a (0, 1) sequence: of any aligned 2^m points one is in each
// 2^-m of the unit interval.
TEST(SampleSequence, EachVariableIsSpreadEvenly) {
    constexpr std::uint32_t n = 256;
    for (int d = 0; d < most_variables; ++d)
        for (std::uint32_t begin : {0U, n, 6 * n}) {
            std::set<int> parts;
            for (std::uint32_t i = 0; i < n; ++i)
                parts.insert(static_cast<int>(
                    n *
                    place(sample_point(begin + i, most_variables)[static_cast<std::size_t>(d)])));
            EXPECT_EQ(parts.size(), n);
        }
}

// The first two variables: one of 2^8 points in each of the rectangles 2^-a by 2^-(8-a).
TEST(SampleSequence, FirstTwoVariablesAreANet) {
    const auto points = sample_points(256, 2);
    for (int a = 0; a <= 8; ++a) {
        std::set<std::pair<int, int>> parts;
        for (std::size_t i = 0; i < 256; ++i)
            parts.insert({static_cast<int>(std::ldexp(place(points[2 * i]), a)),
                          static_cast<int>(std::ldexp(place(points[2 * i + 1]), 8 - a))});
        EXPECT_EQ(parts.size(), 256U) << a;
    }
}

// Products of Chebyshev polynomials are orthogonal under the measure: their means over the points
// vanish faster than 1/sqrt(n), which is .016 here.
TEST(SampleSequence, MeansAreThoseOfTheChebyshevMeasure) {
    constexpr std::uint32_t n = 4096;
    const auto points = sample_points(n, most_variables);
    for (std::size_t d = 0; d < most_variables; ++d)
        for (std::size_t e = 0; e <= d; ++e) {
            double mean = 0;
            for (std::size_t i = 0; i < n; ++i)
                mean += points[i * most_variables + d] * points[i * most_variables + e] / n;
            EXPECT_NEAR(mean, d == e ? 0.5 : 0, 2e-3);
        }
}

TEST(SampleSequence, PointsAreDistinctAndInTheCube) {
    const auto points = sample_points(5000, 3);
    std::set<double> first;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LE(std::abs(points[i]), 1);
        if (i % 3 == 0) first.insert(points[i]);
    }
    EXPECT_EQ(first.size(), 5000U);
}

TEST(SampleSequence, RefusesOtherNumbersOfVariables) {
    EXPECT_THROW(sample_point(0, 0), std::invalid_argument);
    EXPECT_THROW(sample_points(10, most_variables + 1), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::statistics::sample_sequence_test
