#include "contact/base/compensated_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tricontact::compensated_sum_test {
namespace {

using contact::CompensatedSum;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// 0.1 is not 1/10: a million of what it is, which a product rounds once.
TEST(CompensatedSum, OfAMillionTermsIsRoundedOnce) {
    CompensatedSum sum;
    double plain = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        sum.add(.1);
        plain += .1;
    }
    EXPECT_EQ(sum.value(), .1 * 1e6);
    EXPECT_GT(std::abs(plain - .1 * 1e6), 1e-7);
}

TEST(CompensatedSum, KeepsWhatALargeTermHides) {
    CompensatedSum sum;
    for (const double term : {1., 1e100, 1., -1e100}) sum.add(term);
    EXPECT_EQ(sum.value(), 2);
}

TEST(CompensatedSum, TellsNoNumber) {
    CompensatedSum sum;
    for (const double term : {1., std::nan(""), 1.}) sum.add(term);
    EXPECT_TRUE(std::isnan(sum.value()));
}

TEST(BlockSums, CoverEveryTermOnceInOrder) {
    for (const int n : {0, 1, 127, 128, 129, 1000}) {
        int next = 5;
        contact::for_each_block(5, 5 + n, [&](int begin, int end) {
            EXPECT_EQ(begin, next);
            EXPECT_LE(end - begin, contact::summed_block);
            next = end;
        });
        EXPECT_EQ(next, 5 + n);
    }
}

// Terms of one sign and of both, against the compensated sum of each term.
TEST(BlockSums, AreAsExactAsPromised) {
    for (const double offset : {0., .5}) {
        CompensatedSum exact, blocks, magnitude;
        auto term = [&](int i) { return offset + std::sin(i * i * .7); };
        contact::for_each_block(0, 300'000, [&](int begin, int end) {
            double part = 0;
            for (int i = begin; i < end; ++i) {
                part += term(i % 1000);
                exact.add(term(i % 1000));
                magnitude.add(std::abs(term(i % 1000)));
            }
            blocks.add(part);
        });
        EXPECT_LE(std::abs(blocks.value() - exact.value()),
                  contact::sum_rounding * magnitude.value());
    }
    EXPECT_LT(contact::sum_rounding, 100 * epsilon);
}

}  // namespace
}  // namespace tricontact::compensated_sum_test
