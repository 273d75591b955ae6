#include "contact/friction/friction_map.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "contact/base/error.h"

namespace tricontact::contact::friction_map_test {
namespace {

TEST(FrictionMapTable, IsLinearBetweenItsRows) {
    const FrictionMap map({0, 1, 3}, {-1, 1}, {1, 2, 4, 3, 4, 6});
    for (const double x : {0., .4, 1., 2.2, 3.})
        for (const double y : {-1., .3, 1.})
            EXPECT_NEAR(map.at(x, y), 1 + x + (y + 1), 1e-14) << x << ' ' << y;
    const FrictionMap stripes({0, 2}, {}, {0, 4});
    EXPECT_FALSE(stripes.varies_along_y());
    EXPECT_EQ(stripes.at(.5, 1e9), 1);
}

TEST(FrictionMapTable, EndsWhereItsRowsDo) {
    const FrictionMap map({0, 1}, {0, 1}, {1, 1, 1, 1});
    EXPECT_THROW(map.at(1.01, .5), InputError);
    EXPECT_THROW(map.at(.5, -.01), InputError);
    EXPECT_THROW(FrictionMap({0, 0}, {}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(FrictionMap({0, 1}, {}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::contact::friction_map_test
