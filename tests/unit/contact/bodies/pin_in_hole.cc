#include "contact/bodies/pin_in_hole.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"

namespace tricontact::contact::pin_in_hole_test {
namespace {

constexpr double radius = 3, hole = 3.2;

/// Distance from the pin to the hole along the pin's radius at the angle: by bisection, the pin's
/// centre 0.2 below that of the hole.
double distance_at(double angle) {
    double low = 0, high = 1;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2, r = radius + middle;
        const double x = r * std::sin(angle), z = -(hole - radius) - r * std::cos(angle);
        (std::hypot(x, z) < hole ? low : high) = middle;
    }
    return low;
}

TEST(PinInHole, GapIsThatOfBothCircles) {
    const PinInHole pin(radius, hole);
    EXPECT_EQ(pin.height(0, 0), 0);
    for (const double angle : {-1.2, -.3, .01, .7, 1.5})
        EXPECT_NEAR(pin.height(radius * angle, 1) * std::cos(angle), distance_at(angle), 1e-14)
            << angle;
    EXPECT_TRUE(std::isinf(pin.height(radius * 1.56, 0)));
}

// The curvature of x^2/(2 R), 1/R = 1/3 - 1/3.2.
TEST(PinInHole, BeginsAsAParabola) {
    const double x = 1e-3, relative = radius * hole / (hole - radius);
    EXPECT_NEAR(PinInHole(radius, hole).height(x, 0) * 2 * relative / (x * x), 1, 1e-6);
}

TEST(PinInHole, SlopeIsThatOfTheHeight) {
    const PinInHole pin(radius, hole);
    constexpr double h = 1e-5;
    for (const double x : {-2., .4, 3.9})
        EXPECT_NEAR(pin.slope(x, 0)[0], (pin.height(x + h, 0) - pin.height(x - h, 0)) / (2 * h),
                    1e-8);
}

TEST(PinInHole, MustFit) {
    EXPECT_THROW(PinInHole(3, 3), InputError);
    EXPECT_THROW(PinInHole(0, 3), InputError);
}

}  // namespace
}  // namespace tricontact::contact::pin_in_hole_test
