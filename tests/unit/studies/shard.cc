#include "studies/shard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "files/digest.h"

namespace tricontact::shard_test {
namespace {

// Shards divide the points: each belongs to one, and to the same one whatever else is there.
TEST(Shard, DividesAllPoints) {
    constexpr int n = 7, n_points = 400;
    std::vector<int> sizes(n, 0);
    for (int k = 0; k < n_points; ++k) {
        const std::string key = files::digest_of(std::to_string(k));
        int owners = 0;
        for (int i = 1; i <= n; ++i)
            if (studies::Shard{i, n}.has(key)) {
                ++owners;
                ++sizes[i - 1];
            }
        EXPECT_EQ(owners, 1);
    }
    // Of evenly spread digests, sizes are binomial: within four standard deviations.
    for (const int size : sizes) EXPECT_NEAR(size, n_points / 7., 4 * std::sqrt(n_points / 7.));
}

TEST(Shard, ReadsItsText) {
    const studies::Shard part = studies::shard_of("3/8");
    EXPECT_EQ(part.i, 3);
    EXPECT_EQ(part.n, 8);
    EXPECT_TRUE(studies::shard_of("").has("ffff"));
    for (const char* bad : {"0/3", "4/3", "1", "1/", "/2", "a/b", "1/2x", "1/1000000"})
        EXPECT_THROW(studies::shard_of(bad), contact::InputError) << bad;
}

}  // namespace
}  // namespace tricontact::shard_test
