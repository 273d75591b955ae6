// The method of dimensionality reduction under bodies other than the sphere: exact but for the
// length of its springs, static and rolling.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mdr/settings.h"
#include "tests/verification/bodies_cases.h"
#include "tests/verification/mdr/roller.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::mdr_bodies_test {
namespace {

using contact::Case;

class MdrBodies : public testing::TestWithParam<verification::Body> {};

// The midpoint rule's error at 20000 springs, (dx/a)^2/12 = 1e-9; a body's kinks cost ten times it.
TEST_P(MdrBodies, PressesAndShiftsAsTheClosedFormsSay) {
    Case c = verification::body_case(GetParam().shape, GetParam().exponent);
    c.of<mdr::Settings>().springs = 20000;
    c.rolling = Case::Rolling{};  // of amplitude 0
    c.rolling->amplitude_ratio = 0;
    for (const double f : {.3, .9}) {
        c.load.tangential_ratio = f;
        const mdr_test::Roller roller(c);
        const auto exact = contact::half_space_scales(c);
        EXPECT_NEAR(roller.scales().indentation / exact.indentation, 1, 1e-6);
        EXPECT_NEAR(roller.scales().unit_shift / exact.unit_shift, 1, 1e-6);
        EXPECT_NEAR(roller.scales().contact_radius / exact.contact_radius, 1, 1e-3);
        EXPECT_NEAR(roller.shift_ratio(), theory::static_shift_ratio(c, f), 1e-6) << f;
    }
}

TEST_P(MdrBodies, SettlesWhereTheClosedFormSays) {
    Case c = verification::body_case(GetParam().shape, GetParam().exponent);
    c.of<mdr::Settings>().springs = 20000;
    c.rolling = Case::Rolling{};
    c.rolling->steps_per_quarter = 1;
    for (const double w : {.15, .4}) {
        c.rolling->amplitude_ratio = w;
        const double limit = verification::bed_limit(c, w);
        c.load.tangential_ratio = .7 * limit;
        mdr_test::Roller roller(c);
        roller.roll(60);
        EXPECT_NEAR(roller.shift_ratio(), *theory::bed_settled_shift_ratio(c, w, .7 * limit), 2e-6)
            << w;
        EXPECT_NEAR(roller.model().limit_tangential_ratio(), limit, 2e-6) << w;
        EXPECT_TRUE(roller.model().audit().passed());
    }
}

std::vector<verification::Body> of_revolution() {
    auto all = verification::bodies();
    std::erase_if(all, [](const auto& b) { return b.shape == Case::Shape::ellipsoid; });
    return all;
}

INSTANTIATE_TEST_SUITE_P(HalfSpace, MdrBodies, testing::ValuesIn(of_revolution()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace tricontact::mdr_bodies_test
