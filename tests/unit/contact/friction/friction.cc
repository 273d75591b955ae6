#include "contact/friction/friction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::contact::friction_test {
namespace {

TEST(Friction, CarriesWhatItsNumbersSay) {
    const auto law = Friction{.coefficient = .4,
                              .shear_strength = 2e5,
                              .pressure_exponent = .5,
                              .reference_pressure = 1e6,
                              .strength_limit = 5e5}
                         .law();
    EXPECT_FALSE(law->coulomb());
    EXPECT_EQ(law->bound(0), 0);  // out of contact
    EXPECT_EQ(law->bound(-1), 0);
    EXPECT_NEAR(law->bound(1e-9), 2e5, 20);
    EXPECT_DOUBLE_EQ(law->bound(.25e6), 2e5 + .4 * .5e6);
    EXPECT_EQ(law->bound(1e6), 5e5);
    EXPECT_EQ(law->limit({3., 7.}, .5), 3.5) << "of what all points carry";
}

// Each law without what is its own.
TEST(Friction, IsCoulombsInItsLimitCases) {
    const auto coulomb = Friction{.coefficient = .4}.law();
    EXPECT_EQ(coulomb->coulomb(), .4);
    EXPECT_EQ(coulomb->limit({3., 7.}), .4 * 3);
    const Friction near[] = {
        {.coefficient = .4, .shear_strength = 1e-6},
        {.coefficient = .4, .pressure_exponent = 1 + 1e-9, .reference_pressure = 1e6},
        {.coefficient = .4, .strength_limit = 1e12}};
    for (const Friction& one : near)
        for (const double p : {1e3, 1e5, 1e7})
            EXPECT_NEAR(one.law()->bound(p) / coulomb->bound(p), 1, 1e-8) << one.formula();
}

TEST(Friction, SaysItsFormula) {
    EXPECT_EQ((Friction{.coefficient = .4}).formula(), "0.4 p");
    EXPECT_EQ((Friction{.shear_strength = 3.5e5}).formula(), "350 kPa");
    EXPECT_EQ(
        (Friction{.coefficient = .4, .shear_strength = 3.5e5, .strength_limit = 2e6}).formula(),
        "350 kPa + 0.4 p, at most 2 MPa");
    EXPECT_EQ(
        (Friction{.coefficient = .4, .pressure_exponent = .8, .reference_pressure = 1e6}).formula(),
        "0.4 1 MPa (p/1 MPa)^0.8");
}

}  // namespace
}  // namespace tricontact::contact::friction_test
