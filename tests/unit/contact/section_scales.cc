#include "contact/section_scales.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"

namespace tricontact::contact::section_scales_test {
namespace {

using std::numbers::pi;

Case punch(Case::Shape shape, double length) {
    Case c;
    c.indenter.shape = shape;
    c.indenter.flat_radius = .5;
    c.indenter.radius = shape == Case::Shape::rounded_punch ? 50 : 0;
    c.indenter.length = length;
    c.substrate = {2, .3};
    c.friction.coefficient = .5;
    return c;
}

// Ciavarella, Hills and Monno (1998): P R/(E* a^2) = .307092 where b/a = .5.
TEST(SectionScales, PunchAlongYHasTheWidthOfItsClosedForm) {
    Case c = punch(Case::Shape::rounded_punch, 40);
    const double modulus = 2 / .91;
    c.load.normal_force = .307092 * modulus / 50 * 40;
    const HalfSpaceScales scales = half_space_scales(c);
    EXPECT_NEAR(scales.contact_radius, 1, 2e-6);
    // And back from its depth.
    Case deep = punch(Case::Shape::rounded_punch, 40);
    deep.load.indentation = scales.indentation;
    EXPECT_NEAR(half_space_scales(deep).contact_radius, scales.contact_radius, 1e-9);
    EXPECT_NEAR(half_space_scales(deep).normal_force / scales.normal_force, 1, 1e-9);
}

// Sneddon (1965): F = 2 E* b d.
TEST(SectionScales, SharpPunchOfRevolution) {
    Case c = punch(Case::Shape::flat_punch, 0);
    c.load.indentation = 1e-3;
    EXPECT_NEAR(half_space_scales(c).normal_force, 2 * 2 / .91 * .5 * 1e-3, 1e-12);
    EXPECT_EQ(half_space_scales(c).contact_radius, .5);
}

TEST(SectionScales, APinIsNoWiderThanItself) {
    Case c;
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.radius = 10;
    c.indenter.length = 100;
    c.substrate_shape = Case::SubstrateShape::hole;
    c.hole = {10.1, 100};
    c.substrate = {2, .3};
    c.friction.coefficient = .5;
    c.load.normal_force = 1e-3 * 100;
    // Hertz with 1/R = 1/10 - 1/10.1.
    EXPECT_NEAR(half_space_scales(c).contact_radius, std::sqrt(4e-3 * 1010 / (pi * 2 / .91)), 1e-9);
    c.load.normal_force = 1e3;
    EXPECT_EQ(half_space_scales(c).contact_radius, 10);
}

}  // namespace
}  // namespace tricontact::contact::section_scales_test
