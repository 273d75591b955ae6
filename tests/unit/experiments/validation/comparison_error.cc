#include "experiments/validation/comparison_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tricontact::experiments::comparison_error_test {
namespace {

// V&V 20, (4-2-1); with known errors the factor of 95 % is the normal 1.96.
TEST(ComparisonError, SumsSquaresOfItsSources) {
    const ComparisonError e{100e-6, 98e-6, {{"a", 3e-6}, {"b", 4e-6}}};
    EXPECT_DOUBLE_EQ(e.standard_error(), 5e-6);
    EXPECT_NEAR(e.half_width(), 1.959964 * 5e-6, 1e-11);
    EXPECT_TRUE(e.agrees());
    const auto shares = e.shares();
    EXPECT_EQ(shares[0].first, "b");
    EXPECT_NEAR(shares[0].second, .64, 1e-12);
    EXPECT_NEAR(e.resolution(), (1.959964 + 1.644854) * 5 / 98, 1e-6);
}

// Two sources of 3 and 4 um that are correlated by 1/2 where one of them is subtracted: 25 - 12.
TEST(ComparisonError, CountsCovariances) {
    const ComparisonError e{100e-6, 98e-6, {{"a", 3e-6}, {"b", 4e-6}}, -12e-12};
    EXPECT_NEAR(e.standard_error(), std::sqrt(13.) * 1e-6, 1e-15);
    const auto shares = e.shares();
    EXPECT_EQ(shares.back().first, "correlations");
    EXPECT_NEAR(shares.back().second, -12. / 13, 1e-12);
    double sum = 0;
    for (const auto& [name, share] : shares) sum += share;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_TRUE(statement(e, "m").ends_with("b 123 %, a 69 %, correlations −92 %"))
        << statement(e, "m");
    const ComparisonError independent{100e-6, 98e-6, {{"a", 3e-6}, {"b", 4e-6}}};
    EXPECT_EQ(statement(independent, "m").find("correlations"), std::string::npos);
}

// JCGM 100:2008, H.1.6: u_c = 32 nm of 25, 9.7, 2.9 and 16.6 nm by 18, 25.6, 50 and 2 degrees of
// freedom: 16.7 effective ones (16 in the standard), t of 99 % 2.92; of 95 % 2.12.
TEST(ComparisonError, CountsDegreesOfFreedomAsTheGumsGaugeBlocks) {
    const ComparisonError e{0,
                            1,
                            {{"standard", 25e-9, 18},
                             {"comparator", 9.7e-9, 25.6},
                             {"expansion", 2.9e-9, 50},
                             {"temperature", 16.6e-9, 2}}};
    EXPECT_NEAR(e.standard_error(), 32e-9, .5e-9);
    EXPECT_NEAR(e.half_width() / e.standard_error(), 2.120, .001);
}

// A single source keeps its own, whatever rounding does to them.
TEST(ComparisonError, OneSourceHasItsOwnDegreesOfFreedom) {
    for (int degrees = 1; degrees < 200; ++degrees) {
        const ComparisonError e{0, 1, {{"runs", 1e-6 / 3, double(degrees)}}};
        EXPECT_EQ(e.degrees_of_freedom(), degrees);
    }
}

// What the resolution promises, drawn: a deviation of its size is called a disagreement in 95 % of
// the cases, none in 5 %. 1e5 draws scatter by 0.07 %.
TEST(ComparisonError, ADeviationOfItsResolutionIsSeen) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> gauss;
    constexpr int n = 100'000;
    int seen = 0, wrongly = 0;
    for (int i = 0; i < n; ++i) {
        ComparisonError e{0, 100, {{"a", 3}, {"b", 4}}};
        const double noise = 3 * gauss(random) + 4 * gauss(random);
        e.measured = 100 + noise;
        wrongly += !e.agrees();
        e.measured += 100 * e.resolution();
        seen += !e.agrees();
    }
    EXPECT_NEAR(seen / double(n), .95, .003);
    EXPECT_NEAR(wrongly / double(n), .05, .003);
}

TEST(ComparisonError, IsTold) {
    const ComparisonError e{
        101.4e-6, 100e-6, {{"substrate.young", 3e-6}, {"repeated runs", 1e-6}, {"mesh", 1e-7}}};
    EXPECT_EQ(
        statement(e, "m"),
        "measured minus computed: +1.4 ± 6.2 µm (95 %): agrees; this comparison would have seen "
        "11 %; largest contributors: substrate.young 90 %, repeated runs 10 %");
    const ComparisonError off{80e-6, 100e-6, {{"mesh", 1e-6}}};
    EXPECT_EQ(statement(off, "m").find("measured minus computed: −20.0 ± 2.0 µm (95 %): disagrees"),
              0U)
        << statement(off, "m");
}

}  // namespace
}  // namespace tricontact::experiments::comparison_error_test
