// load.limit_fraction by finite elements, linear and at finite strains.

#include <gtest/gtest.h>

#include "tests/verification/fem/strained_rig.h"

namespace tricontact::fem::limit_fraction_test {
namespace {

using contact::Case;
using contact::History;

Case rolled(Case c) {
    c.load.tangential_force.reset();
    c.rolling = Case::Rolling{};
    c.rolling->amplitude_ratio = .3;
    c.rolling->periods = 2;
    c.rolling->steps = Case::Steps::turning_points;
    return c;
}

void expect_own_fraction(const Case& given) {
    Case c = given, other = given;
    c.load.limit_fraction = .5;
    const auto model = make_layer_model(c);
    const History found = contact::run(c, *model);
    const double f = found.tangential_force / found.friction_limit;
    // What friction does to the pressures of this layer.
    EXPECT_NEAR(f / (.5 * found.limit_tangential_ratio), 1, .05);
    other.load.tangential_ratio = f;
    const History expected = contact::run(other, *make_layer_model(other));
    const double unit = found.scales.unit_shift;
    EXPECT_NEAR(found.static_shift / unit, expected.static_shift / unit, 1e-4);
    EXPECT_NEAR(found.shift_per_period.back() / unit, expected.shift_per_period.back() / unit,
                1e-4);
}

TEST(FemLimitFraction, OfTheLinearLayer) {
    expect_own_fraction(rolled(layer_case(1e-3)));
}

TEST(FemLimitFraction, AtFiniteStrains) {
    expect_own_fraction(rolled(strained_case(1.4e-3)));
}

}  // namespace
}  // namespace tricontact::fem::limit_fraction_test
