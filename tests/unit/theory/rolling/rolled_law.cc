#include "theory/rolling/rolled_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact/base/error.h"
#include "theory/rolling/bed_under_law.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::rolled_law_test {
namespace {

using std::numbers::pi;
using theory::coulomb_rolling;
using theory::RolledLaw;
using theory::strength_rolling;

// Of the springs' own integrals, of any law.
TEST(RolledLaw, AStrengthSettlesWhereItsSpringsDo) {
    contact::Case c;
    c.indenter.shape = contact::Case::Shape::paraboloid;
    c.indenter.radius = .04;
    c.substrate = {2e6, .5};
    c.load.normal_force = 3;
    c.friction.shear_strength = 2e5;
    const theory::BedUnderLaw bed(c);
    for (const double w : {0., .2, .5})
        for (const double share : {.1, .5, .95}) {
            const double f = share * bed.shakedown_limit(w);
            EXPECT_NEAR(*strength_rolling.settled_shift_ratio(w, f, 4 / pi),
                        *bed.settled_shift_ratio(w, f), 2e-6)
                << w << ' ' << share;
        }
    for (const double w : {.1, .6})
        EXPECT_NEAR(strength_rolling.exact_limit(w), bed.shakedown_limit(w), 1e-6);
}

TEST(RolledLaw, CoulombsIsThatOfParaboloids) {
    EXPECT_EQ(coulomb_rolling.settled_shift_ratio(.3, .2, 1.2),
              theory::settled_shift_ratio(.3, .2, 1.2));
    EXPECT_EQ(coulomb_rolling.mapping_parameter(.3, .2, .4), theory::mapping_parameter(.3, .2, .4));
    EXPECT_EQ(coulomb_rolling.exact_limit(.3), theory::shakedown_limit(.3));
}

TEST(RolledLaw, GivesItsKappaBackAndSlopesAreThoseOfItsForce) {
    for (const RolledLaw* law : {&coulomb_rolling, &strength_rolling})
        for (const double share : {.6, .9, 1.}) {
            const double w = .4, f = .3, kappa = share * law->mdr_mapping;
            const double u = *law->settled_shift_ratio(w, f, kappa);
            EXPECT_NEAR(law->mapping_parameter(w, f, u), kappa, 1e-10);
            EXPECT_NEAR((law->static_force(u + 1e-6) - law->static_force(u - 1e-6)) / 2e-6,
                        law->static_slope(u), 1e-8);
            EXPECT_FALSE(law->settled_shift_ratio(w, law->shakedown_limit(w, kappa) + 1e-9, kappa));
            EXPECT_EQ(law->static_force(0), 0);
            EXPECT_NEAR(law->static_force(1), 1, 1e-15);
            EXPECT_THROW(law->settled_shift_ratio(w, f, 1.01 * law->mdr_mapping),
                         std::domain_error);
            EXPECT_THROW(law->mapping_parameter(0, f, u), std::domain_error);
            EXPECT_THROW(law->mapping_parameter(w, f, 1.1), std::domain_error);
        }
}

TEST(RolledLaw, OfACase) {
    using contact::Friction;
    EXPECT_EQ(theory::rolled_law(Friction{.coefficient = .5}), &coulomb_rolling);
    EXPECT_EQ(theory::rolled_law(Friction{.shear_strength = 1e5}), &strength_rolling);
    for (const Friction& other : {Friction{.coefficient = .5, .shear_strength = 1e5},
                                  Friction{.coefficient = .5, .strength_limit = 1e5},
                                  Friction{.shear_strength = 1e5, .strength_limit = 1e6}}) {
        EXPECT_EQ(theory::rolled_law(other), nullptr);
        contact::Case c;
        c.friction = other;
        try {
            theory::require_rolled_law(c, "maps");
            ADD_FAILURE();
        } catch (const contact::InputError& error) {
            EXPECT_NE(std::string(error.what()).find("friction: maps presume Coulomb's law"),
                      std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace tricontact::rolled_law_test
