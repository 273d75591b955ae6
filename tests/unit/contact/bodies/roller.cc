#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "contact/base/error.h"
#include "contact/bodies/cylinder.h"

namespace tricontact::roller_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Roller, IsACylinderBetweenItsEnds) {
    const contact::Cylinder sharp(.04, .08, 0), rounded(.04, .08, .001);
    for (const double y : {-.039, 0., .02, .039}) {
        EXPECT_DOUBLE_EQ(sharp.height(.002, y), 5e-5);
        EXPECT_DOUBLE_EQ(rounded.height(-.002, y), 5e-5);
        EXPECT_DOUBLE_EQ(sharp.slope(.002, y)[0], .05);
        EXPECT_EQ(sharp.slope(.002, y)[1], 0);
    }
    EXPECT_DOUBLE_EQ(sharp.height(.002, .04), 5e-5);
    EXPECT_EQ(sharp.height(0, std::nextafter(.04, 1)), infinity);
}

TEST(Roller, RoundedEndsAreQuartersOfACircle) {
    const contact::Cylinder roller(.04, .08, .001);
    for (const double s : {0., 1e-5, 4e-4, 9e-4, 1e-3}) {
        const double h = roller.height(0, -.039 - s), r = .001;
        // y carries roundings of 1e-16 of 40 mm, which the steep end multiplies
        EXPECT_NEAR(s * s + (r - h) * (r - h), r * r, 1e-16) << s;
    }
    EXPECT_EQ(roller.height(0, .0401), infinity);
}

TEST(Roller, SlopesAreDerivatives) {
    const contact::Cylinder roller(.04, .08, .004);
    const double step = 1e-7;
    for (const double y : {-.039, -.01, .0365, .039}) {
        const double difference =
            (roller.height(.003, y + step) - roller.height(.003, y - step)) / (2 * step);
        // truncation: 1e-14 over the square of 1 mm; cancellation: 1e-16 of 1e-4 m over the step
        EXPECT_NEAR(roller.slope(.003, y)[1], difference, 1e-7) << y;
    }
}

TEST(Roller, LengthsThatAreNoneAreRefused) {
    EXPECT_THROW(contact::Cylinder(0, 1, 0), contact::InputError);
    EXPECT_THROW(contact::Cylinder(1, infinity, 0), contact::InputError);
    EXPECT_THROW(contact::Cylinder(1, 1, .51), contact::InputError);
    EXPECT_THROW(contact::Cylinder(1, 1, -1e-3), contact::InputError);
    EXPECT_NO_THROW(contact::Cylinder(1, 1, .5));
}

}  // namespace
}  // namespace tricontact::roller_test
