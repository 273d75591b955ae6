#include "theory/hertz_under_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/bed_under_law.h"

namespace tricontact::theory::hertz_under_law_test {
namespace {

contact::Case lens(const contact::Friction& friction) {
    contact::Case c;
    c.indenter.radius = 7e-3;
    c.substrate = {1.8e6, .5};
    c.friction = friction;
    c.load.normal_force = .6;
    return c;
}

// f_T = (2/pi) [u sqrt(1 - u^2) + arcsin u]; numbers of another simulation by springs.
TEST(HertzUnderLaw, AStrengthAloneHasItsClosedForm) {
    const contact::Case c = lens({.shear_strength = .35e6});
    const HertzUnderLaw law(c);
    const double a = contact::half_space_scales(c).contact_radius;
    EXPECT_NEAR(law.friction_limit() / (std::numbers::pi * a * a * .35e6), 1, 1e-14);
    EXPECT_NEAR(law.unit_shift() * c.materials().effective_shear_modulus() / (2 * .35e6 * a), 1,
                1e-14);
    const double published[][2] = {{.3, .23788}, {.55, .44738}, {.2, .15774}, {.35, .27853}};
    for (const auto& [f, u] : published)
        EXPECT_NEAR(law.shift(f * law.friction_limit()) / law.unit_shift(), u, 6e-6);
    for (const double u : {.001, .2, .6, .9, .999}) {
        const double f = 2 / std::numbers::pi * (u * std::sqrt(1 - u * u) + std::asin(u));
        EXPECT_NEAR(law.shift(f * law.friction_limit()) / law.unit_shift() / u, 1, 1e-9);
    }
}

TEST(HertzUnderLaw, CoulombsLawIsCattaneoAndMindlins) {
    const contact::Case c = lens({.coefficient = .8});
    const HertzUnderLaw law(c);
    EXPECT_NEAR(law.friction_limit() / (.8 * .6), 1, 1e-13);
    EXPECT_NEAR(law.unit_shift() / contact::half_space_scales(c).unit_shift, 1, 1e-13);
    for (const double f : {.01, .3, .7, .98, 1.})
        EXPECT_NEAR(law.shift(f * law.friction_limit()) / law.unit_shift(), static_shift_ratio(f),
                    1e-11);
}

// The same theory by tables of any body's pressure, of which pressures are linear between 512
// points: 1e-5 of the shift.
TEST(HertzUnderLaw, AllLawsAgreeWithTheBedOfSprings) {
    const contact::Friction laws[] = {
        {.coefficient = .5, .shear_strength = .1e6},
        {.coefficient = .5, .pressure_exponent = .6, .reference_pressure = .2e6},
        {.coefficient = .5, .pressure_exponent = 1.4, .reference_pressure = .2e6},
        {.coefficient = .5, .strength_limit = .1e6},
        {.coefficient = .5,
         .shear_strength = .05e6,
         .pressure_exponent = .7,
         .reference_pressure = .2e6,
         .strength_limit = .12e6}};
    for (const contact::Friction& friction : laws) {
        const contact::Case c = lens(friction);
        const HertzUnderLaw law(c);
        const BedUnderLaw bed(c);
        EXPECT_NEAR(law.friction_limit() / bed.friction_limit(), 1, 2e-5) << friction.formula();
        for (const double f : {.1, .4, .8, .97})
            EXPECT_NEAR(law.shift(f * law.friction_limit()) / law.unit_shift(),
                        bed.static_shift_ratio(f), 3e-5)
                << friction.formula() << f;
    }
}

// F_lim ~ F_N^((2 + n)/3): a ~ F_N^(1/3), p_0 ~ F_N^(1/3).
TEST(HertzUnderLaw, LimitsGrowWithAPowerOfTheLoad) {
    for (const double n : {.3, 2. / 3, 1.}) {
        contact::Friction friction{.coefficient = .5};
        if (n != 1) friction.pressure_exponent = n, friction.reference_pressure = 1e5;
        contact::Case c = lens(friction);
        const double at_one = HertzUnderLaw(c).friction_limit();
        *c.load.normal_force *= 8;
        EXPECT_NEAR(HertzUnderLaw(c).friction_limit() / at_one, std::pow(2, 2 + n), 1e-12);
    }
}

TEST(HertzUnderLaw, NothingIsShiftedByMoreThanFrictionCarries) {
    const HertzUnderLaw law(lens({.shear_strength = .35e6}));
    EXPECT_THROW(law.shift(1.001 * law.friction_limit()), contact::InputError);
    EXPECT_EQ(law.shift(0), 0);
}

}  // namespace
}  // namespace tricontact::theory::hertz_under_law_test
