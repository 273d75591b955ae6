// Where a force curve begins to touch: the guess that the search starts from.

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments::zero_depth_test {
namespace {

/// Hertz' F = c (d - zero)^(3/2), nothing before contact, at depths of 100 nm.
IdentificationInput::Table curve(double zero) {
    IdentificationInput::Table table{.measurement =
                                         IdentificationInput::Measurement::force_indentation};
    table.has_free_zero = true;
    for (int k = -20; k <= 40; ++k) {
        const double touched = 1e-7 * k;
        table.given.push_back(zero + touched);
        table.observed.push_back(touched > 0 ? 3e3 * std::pow(touched, 1.5) : 0);
    }
    return table;
}

// F^(2/3) of Hertz' contact is a straight line: exact to rounding of the depths' range.
TEST(ZeroDepth, GuessIsExactForHertz) {
    for (const double zero : {0., -3e-6, 5e-5})
        EXPECT_NEAR(zero_depth_guess(curve(zero)), zero, 1e-6 * 6e-6) << zero;
}

TEST(ZeroDepth, GuessLiesBelowADepthWithAForce) {
    auto falling = curve(0);
    for (std::size_t k = 0; k < falling.observed.size(); ++k)
        falling.observed[k] = 1. / (1. + static_cast<double>(k));
    EXPECT_EQ(zero_depth_guess(falling), falling.given.front());
}

}  // namespace
}  // namespace tricontact::experiments::zero_depth_test
