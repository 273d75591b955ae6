#include "statistics/latin_hypercube.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tricontact::statistics::latin_hypercube_test {
namespace {

// First numbers of the seed 1234567, as other implementations of the algorithm give them.
TEST(SplitMix64, GivesTheKnownNumbers) {
    SplitMix64 random(1234567);
    for (const std::uint64_t due :
         {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
          16408922859458223821U})
        EXPECT_EQ(random.next(), due);
}

TEST(SplitMix64, IsUniform) {
    SplitMix64 random(7);
    constexpr int n = 60'000, n_parts = 6;
    std::vector<int> counts(n_parts, 0);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        ++counts[random.below(n_parts)];
        const double value = random.uniform();
        ASSERT_TRUE(value >= 0 && value < 1);
        sum += value;
    }
    // Five standard deviations: of a count sqrt(n p (1 - p)), of a mean 1/sqrt(12 n).
    for (const int count : counts)
        EXPECT_NEAR(count, n / n_parts, 5 * std::sqrt(n * (1. / 6) * (5. / 6)));
    EXPECT_NEAR(sum / n, 0.5, 5 / std::sqrt(12. * n));
}

RC_GTEST_PROP(LatinHypercube, HasOnePointInEachPartOfEachAxis, ()) {
    const int n = *rc::gen::inRange(1, 200);
    const int n_axes = *rc::gen::inRange(1, 6);
    const auto sample = latin_hypercube(n, n_axes, *rc::gen::arbitrary<std::uint64_t>());
    RC_ASSERT(sample.size() == static_cast<std::size_t>(n_axes));
    for (const auto& values : sample) {
        std::vector<int> parts;
        for (const double value : values) parts.push_back(static_cast<int>(std::floor(value * n)));
        std::sort(parts.begin(), parts.end());
        std::vector<int> all(static_cast<std::size_t>(n));
        std::iota(all.begin(), all.end(), 0);
        RC_ASSERT(parts == all);
    }
}

TEST(LatinHypercube, ComesAgainWithItsSeedOnly) {
    EXPECT_EQ(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 5));
    EXPECT_NE(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 6));
    const auto sample = latin_hypercube(20, 2, 5);
    EXPECT_NE(sample[0], sample[1]);  // axes have shuffles of their own
}

}  // namespace
}  // namespace tricontact::statistics::latin_hypercube_test
