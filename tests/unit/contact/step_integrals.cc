#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "contact/substrates/relaxation.h"

namespace tricontact::step_integrals_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

// The definitions evaluated with 100 digits. Where both series and closed forms used to lose
// digits, 1e-4 < x < 1e-2, the error was 1e-9 of the value.
TEST(StepIntegrals, AreRightToRoundingForEveryDuration) {
    const double rounding = 8 * std::numeric_limits<double>::epsilon();
    for (double x = 1e-12; x < 1e4; x *= 1.37) {
        const contact::StepIntegrals s(x);
        const Exact y = x, once = 1 - exp(-y), ee = (1 - exp(-2 * y)) / 2;
        EXPECT_NEAR(s.mean, static_cast<double>(once / y), rounding) << x;
        EXPECT_NEAR(s.drift, static_cast<double>((1 - once / y) / y), rounding) << x;
        EXPECT_NEAR(s.ee, static_cast<double>(ee), rounding) << x;
        EXPECT_NEAR(s.ew, static_cast<double>((once - ee) / y), rounding) << x;
        EXPECT_NEAR(s.ww, static_cast<double>((ee - 2 * once + y) / (y * y)), rounding) << x;
    }
}

TEST(StepIntegrals, OfNoTimeAndOfAllTime) {
    const contact::StepIntegrals none(0), all(std::numeric_limits<double>::infinity());
    EXPECT_EQ(none.mean, 1);
    EXPECT_EQ(none.drift, .5);
    EXPECT_EQ(none.ee, 0);
    EXPECT_EQ(none.ew, 0);
    EXPECT_EQ(none.ww, 0);
    EXPECT_EQ(all.mean, 0);
    EXPECT_EQ(all.drift, 0);
    EXPECT_EQ(all.ee, .5);
    EXPECT_EQ(all.ew, 0);
    EXPECT_EQ(all.ww, 0);
}

}  // namespace
}  // namespace tricontact::step_integrals_test
