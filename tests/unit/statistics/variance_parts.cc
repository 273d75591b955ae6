#include "statistics/variance_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "statistics/joint_covariance.h"
#include "statistics/variance_sizes.h"

namespace tricontact::statistics::variance_parts_test {

namespace {

const std::vector<double> first{3.1, 2.7, 3.4, 2.9}, second{5.2, 7.9, 4.4, 6.8, 6.1, 3.9};

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double variance_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::pow(value - mean_of(values), 2);
    return sum / static_cast<double>(values.size() - 1);
}

}  // namespace

// Two samples of unlike variances: restricted maximum likelihood has the sample variances, and the
// difference of the means the degrees of freedom of Welch (1947, Biometrika 34, 28).
TEST(VarianceParts, OfTwoSamplesAreWelchs) {
    std::vector<double> all = first, in_second(first.size(), 0.), in_first(first.size(), 1.);
    all.insert(all.end(), second.begin(), second.end());
    in_second.resize(all.size(), 1);
    in_first.resize(all.size(), 0);
    const std::vector<double> ones(all.size(), 1.);
    const auto sizes = variance_sizes(
        {in_second}, {ones}, all,
        {.fixed = std::vector<double>(all.size()), .parts = {in_first, in_second}, .least = {0, 0}},
        {1, 1});
    const double v1 = variance_of(first), v2 = variance_of(second);
    EXPECT_NEAR(sizes[0], v1, 1e-6 * v1);
    EXPECT_NEAR(sizes[1], v2, 1e-6 * v2);

    std::vector<double> difference = in_second, mean = ones;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double error = std::sqrt(i < first.size() ? v1 : v2);
        difference[i] /= error;
        mean[i] /= error;
    }
    // What is left of the difference beside the mean, as fits hand it on.
    double product = 0, square = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        product += difference[i] * mean[i];
        square += mean[i] * mean[i];
    }
    for (std::size_t i = 0; i < all.size(); ++i) difference[i] -= product / square * mean[i];
    const auto c = joint_covariance(
        {difference},
        {{.n_rows = all.size(), .n_own = 1, .is_known = false, .parts = {in_first, in_second}}},
        {mean});
    const double n1 = static_cast<double>(first.size()), n2 = static_cast<double>(second.size());
    const double s1 = v1 / n1, s2 = v2 / n2;
    EXPECT_NEAR(c.covariance[0][0], s1 + s2, 1e-12);
    EXPECT_NEAR(c.effective_degrees[0],
                std::pow(s1 + s2, 2) / (s1 * s1 / (n1 - 1) + s2 * s2 / (n2 - 1)), 1e-6);
}

// Parts that overlap: no other sizes have a larger restricted likelihood,
// -2 ln L = sum ln v + ln(sum 1/v) + sum r^2/v of the residuals from the weighted mean.
TEST(VarianceParts, OfOverlappingPartsAreMostLikely) {
    std::vector<double> ones(second.size(), 1.), growing;
    for (std::size_t i = 0; i < second.size(); ++i) growing.push_back(static_cast<double>(i * i));
    const std::vector<double> scattered{1.5, -1.4, 1.1, -1.6, 4.1, -3.3};
    const VarianceSum sum{std::vector<double>(ones.size()), {ones, growing}, {1e-6, 0}};
    const auto sizes = variance_sizes({ones}, {}, scattered, sum, {.5, .5});
    const auto minus_two_log = [&](const std::vector<double>& of) {
        double weights = 0, mean = 0, result = 0;
        const auto v = sum.of(of);
        for (std::size_t i = 0; i < v.size(); ++i) {
            weights += 1 / v[i];
            mean += scattered[i] / v[i];
            result += std::log(v[i]);
        }
        mean /= weights;
        for (std::size_t i = 0; i < v.size(); ++i)
            result += std::pow(scattered[i] - mean, 2) / v[i];
        return result + std::log(weights);
    };
    EXPECT_GT(sizes[0], 0);
    EXPECT_GT(sizes[1], 0);
    for (const double by : {.9, .99, 1.01, 1.1}) {
        EXPECT_GT(minus_two_log({by * sizes[0], sizes[1]}), minus_two_log(sizes));
        EXPECT_GT(minus_two_log({sizes[0], by * sizes[1]}), minus_two_log(sizes));
    }
}

}  // namespace tricontact::statistics::variance_parts_test
