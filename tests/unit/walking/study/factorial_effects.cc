#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "contact/base/error.h"
#include "walking/study/walk_factorial.h"

namespace tricontact::walking::factorial_effects_test {
namespace {

/// Parts that sum to zero over each factor: orthogonal in a complete design.
constexpr double main_a[] = {-0.3, 0.1, 0.2};
constexpr double main_b[] = {0.5, -0.5};
constexpr double main_c[] = {-0.02, 0, 0.02};
constexpr double pair_ab[3][2] = {{0.04, -0.04}, {-0.01, 0.01}, {-0.03, 0.03}};
constexpr double triple[3] = {1, -2, 1};  // times the signs of b, times that of c

using Response = std::function<double(std::size_t a, std::size_t b, std::size_t c)>;

FactorialDesign design_of(const Response& response) {
    FactorialDesign design{.factors = {{"a", {1, 2, 3}}, {"b", {0, 1}}, {"c", {-1, 0, 1}}},
                           .response = {}};
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 2; ++b)
            for (std::size_t c = 0; c < 3; ++c) design.response.push_back(response(a, b, c));
    return design;
}

double sum_of_pairs(std::size_t a, std::size_t b, std::size_t c) {
    return 2 + main_a[a] + main_b[b] + main_c[c] + pair_ab[a][b];
}

/// Interaction of all three, orthogonal to everything else.
double rest(std::size_t a, std::size_t b, std::size_t c) {
    return 0.001 * triple[a] * (b == 0 ? 1 : -1) * (static_cast<double>(c) - 1);
}

TEST(FactorialEffects, RecoversTheParts) {
    const FactorialDesign design =
        design_of([](auto a, auto b, auto c) { return sum_of_pairs(a, b, c) + rest(a, b, c); });
    const std::vector<MainEffect> effects = main_effects(design);
    ASSERT_EQ(effects.size(), 3u);
    for (std::size_t a = 0; a < 3; ++a)
        EXPECT_NEAR(effects[0].means[a].value, 2 + main_a[a], 1e-14);
    for (std::size_t b = 0; b < 2; ++b)
        EXPECT_NEAR(effects[1].means[b].value, 2 + main_b[b], 1e-14);
    EXPECT_EQ(effects[1].n, (std::vector{9, 9}));

    const VarianceAnalysis analysis = variance_analysis(design);
    ASSERT_EQ(analysis.interactions.size(), 3u);
    const Interaction& ab = analysis.interactions[0];
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 2; ++b)
            EXPECT_NEAR(ab.effects[2 * a + b].value, pair_ab[a][b], 1e-14);
    for (const report::WithError& effect : analysis.interactions[1].effects)
        EXPECT_NEAR(effect.value, 0, 1e-14);
}

// Two values leave one degree of freedom, t = 12.706; 1 and 3 have the mean 2 with a standard error
// of 1, 5 and 11 the mean 8 with 3.
TEST(FactorialEffects, ErrorsOfMeansAreStudents) {
    const auto effect =
        main_effects({.factors = {{"a", {0, 1}}, {"b", {0, 1}}}, .response = {1, 3, 5, 11}}).at(0);
    EXPECT_NEAR(effect.means[0].value, 2, 1e-14);
    EXPECT_NEAR(effect.means[0].error, 12.7062, 1e-4);
    EXPECT_NEAR(effect.means[1].value, 8, 1e-14);
    EXPECT_NEAR(effect.means[1].error, 3 * 12.7062, 3e-4);
}

/// Sums of squares of orthogonal parts over the 18 combinations.
TEST(FactorialEffects, SharesAreThoseOfTheSumsOfSquares) {
    const FactorialDesign design =
        design_of([](auto a, auto b, auto c) { return sum_of_pairs(a, b, c) + rest(a, b, c); });
    double of_a = 0, of_b = 0, of_c = 0, of_ab = 0, of_rest = 0;
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 2; ++b)
            for (std::size_t c = 0; c < 3; ++c) {
                of_a += std::pow(main_a[a], 2);
                of_b += std::pow(main_b[b], 2);
                of_c += std::pow(main_c[c], 2);
                of_ab += std::pow(pair_ab[a][b], 2);
                of_rest += std::pow(rest(a, b, c), 2);
            }
    const double total = of_a + of_b + of_c + of_ab + of_rest;
    const VarianceAnalysis analysis = variance_analysis(design);
    EXPECT_NEAR(analysis.main_shares[0], of_a / total, 1e-12);
    EXPECT_NEAR(analysis.main_shares[1], of_b / total, 1e-12);
    EXPECT_NEAR(analysis.main_shares[2], of_c / total, 1e-12);
    EXPECT_NEAR(analysis.interactions[0].share, of_ab / total, 1e-12);
    EXPECT_NEAR(analysis.explained_by_factors, (of_a + of_b + of_c) / total, 1e-12);
    EXPECT_NEAR(analysis.explained_by_pairs, 1 - of_rest / total, 1e-12);
    // 18 combinations less 1 + 2 + 1 + 2 + 2 + 4 + 2 parts leave four degrees of freedom.
}

/// Least squares finds the parts where combinations are missing.
TEST(FactorialEffects, InteractionsStandExclusions) {
    FactorialDesign design = design_of(sum_of_pairs);
    for (const std::size_t i : {0u, 4u, 11u}) design.response[i] = NAN;
    const VarianceAnalysis analysis = variance_analysis(design);
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 2; ++b)
            EXPECT_NEAR(analysis.interactions[0].effects[2 * a + b].value, pair_ab[a][b], 1e-13);
    EXPECT_EQ(main_effects(design)[0].n, (std::vector{4, 5, 6}));
}

/// 95 % intervals hold the truth in 95 % of noisy experiments: binomial, three deviations.
TEST(FactorialEffects, IntervalsCover) {
    std::mt19937_64 random(20261122);
    std::normal_distribution<double> noise(0, 0.1);
    constexpr int n_experiments = 400;
    int n_held = 0;
    for (int k = 0; k < n_experiments; ++k) {
        const auto analysis = variance_analysis(design_of(
            [&](auto a, auto b, auto c) { return sum_of_pairs(a, b, c) + noise(random); }));
        const report::WithError& effect = analysis.interactions[0].effects[5];
        n_held += std::abs(effect.value - pair_ab[2][1]) <= effect.error;
    }
    EXPECT_NEAR(n_held / double{n_experiments}, 0.95, 3 * std::sqrt(0.95 * 0.05 / n_experiments));
}

TEST(FactorialEffects, RefusesWhatCannotBeTold) {
    FactorialDesign design = design_of(sum_of_pairs);
    for (std::size_t c = 0; c < 3; ++c) design.response[c] = NAN;  // a = 1 with b = 0: all
    EXPECT_THROW(variance_analysis(design), contact::NotConverged);
    EXPECT_EQ(main_effects(design)[0].n, (std::vector{3, 6, 6}));
}

}  // namespace
}  // namespace tricontact::walking::factorial_effects_test
