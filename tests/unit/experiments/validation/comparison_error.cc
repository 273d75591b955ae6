#include "experiments/validation/comparison_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "statistics/estimate.h"

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

// A single source keeps its Student's t, and known ones beside it their normal distribution.
TEST(ComparisonError, OneSourceHasItsOwnDegreesOfFreedom) {
    for (int degrees = 1; degrees < 200; ++degrees) {
        const ComparisonError e{0, 1, {{"runs", 1e-6 / 3, double(degrees)}}};
        EXPECT_DOUBLE_EQ(e.half_width(), statistics::student_t(.95, degrees) * 1e-6 / 3);
    }
    const ComparisonError e{0, 1, {{"runs", 1e-9, 1}, {"number", 1e-6}}};
    EXPECT_NEAR(e.half_width() / 1e-6, 1.96, .01);
}

// Two and three runs beside a known error of any size, drawn: at most 5 % of what is true is called
// a disagreement. 20000 draws scatter by .15 %, here three times. (Welch and Satterthwaite's
// effective degrees of freedom, which stood here: 8.9 % at worst.)
TEST(ComparisonErrorSlow, FewRunsRejectNoMoreThanTheyClaim) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> gauss;
    constexpr int n = 6000;  // .05 scatters by .0028, here three times
    for (const int runs : {2, 3, 5})
        for (const double known : {0., .3, 1., 3.}) {
            int wrongly = 0;
            for (int i = 0; i < n; ++i) {
                double sum = 0, squares = 0;
                for (int k = 0; k < runs; ++k) {
                    const double x = gauss(random);
                    sum += x;
                    squares += x * x;
                }
                const double mean = sum / runs,
                             error = std::sqrt((squares - mean * sum) / (runs - 1) / runs);
                const ComparisonError e{mean + known * gauss(random),
                                        0,
                                        {{"runs", error, runs - 1.}, {"number", known}}};
                wrongly += !e.agrees();
            }
            EXPECT_LT(wrongly / double(n), .05 + .0084) << runs << " runs, " << known;
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
