#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "walking/report/map_page.h"

namespace tricontact::walking::packed_samples_test {
namespace {

// Whole numbers -32767, 0 and 32767 are the bytes 01 80 00 00 FF 7F: coreutils' base64.
TEST(PackedSamples, AreLittleEndianWholeNumbersOfWhatTheySpan) {
    const PackedSamples result = packed(std::vector<float>{-3, 1, 5});
    EXPECT_EQ(result.base64, "AYAAAP9/");
    EXPECT_DOUBLE_EQ(result.offset, 1);
    EXPECT_DOUBLE_EQ(result.scale * 32767, 4);
}

TEST(PackedSamples, OfAConstantAreItsOffset) {
    const PackedSamples result = packed(std::vector<float>{0.25f, 0.25f});
    EXPECT_EQ(result.base64, "AAAAAA==");
    EXPECT_EQ(result.offset, 0.25);
    EXPECT_EQ(result.scale, 0);
}

TEST(PackedSamples, MustBeFinite) {
    EXPECT_EQ(packed({}).base64, "");
    EXPECT_THROW(packed(std::vector<float>{1, std::nanf("")}), std::invalid_argument);
    EXPECT_THROW(packed(std::vector<float>{std::numeric_limits<float>::infinity()}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::walking::packed_samples_test
