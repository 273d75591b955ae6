#include "contact/substrates/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "contact/base/error.h"

namespace tricontact::material_test {
namespace {

using contact::Material;
using contact::MaterialPair;

constexpr double rounding = 1e-15;

TEST(Material, ShearModulus) {
    EXPECT_DOUBLE_EQ((Material{2.5, .25}.shear_modulus()), 1);
    EXPECT_DOUBLE_EQ((Material{3, .5}.shear_modulus()), 1);
    EXPECT_DOUBLE_EQ((Material{8, 0}.shear_modulus()), 4);
}

TEST(Material, ShearModulusChangesAndBulkModulusDoesNot) {
    for (const double nu : {-.9, 0., .3, .4999, .5})
        for (const double ratio : {.1, 1., 3., 50.}) {
            const contact::Material before{5e6, nu}, after = before.with_shear_ratio(ratio);
            EXPECT_NEAR(after.shear_modulus() / before.shear_modulus(), ratio, 1e-13 * ratio);
            // 1/K = 3 (1 - 2 nu)/E
            EXPECT_NEAR((1 - 2 * after.poisson) / after.young, (1 - 2 * nu) / 5e6, 1e-20);
            EXPECT_GT(after.poisson, -1);
        }
}

TEST(MaterialPair, RigidIndenter) {
    // E* = E/(1 - nu^2), G* = 4 G/(2 - nu)
    const MaterialPair rubber({}, {3, .5});
    EXPECT_NEAR(rubber.effective_modulus(), 4, 4 * rounding);
    EXPECT_NEAR(rubber.effective_shear_modulus(), 8. / 3, 4 * rounding);
    EXPECT_EQ(rubber.dundurs_beta(), 0);  // incompressible against rigid
    const MaterialPair cork({}, {8, 0});
    EXPECT_NEAR(cork.effective_modulus(), 8, 8 * rounding);
    EXPECT_NEAR(cork.effective_shear_modulus(), 8, 8 * rounding);
    EXPECT_NEAR(cork.dundurs_beta(), .5, rounding);  // its largest value at nu >= 0
}

TEST(MaterialPair, TwoBodiesByHand) {
    // G = 1, nu = 1/4 on G = 4, nu = 0:
    // 1/E* = 3/8 + 1/8, 1/G* = 7/16 + 1/8, beta = 1/2 (1/4 - 1/2)/(1/4 + 3/4).
    const MaterialPair pair(Material{2.5, .25}, {8, 0});
    EXPECT_NEAR(pair.effective_modulus(), 2, 2 * rounding);
    EXPECT_NEAR(pair.effective_shear_modulus(), 16. / 9, 2 * rounding);
    EXPECT_NEAR(pair.dundurs_beta(), -.125, rounding);
    EXPECT_NEAR(pair.one_minus_nu_over_g(), 1, rounding);
    EXPECT_NEAR(pair.nu_over_g(), .25, rounding);
    EXPECT_NEAR(pair.one_minus_two_nu_over_g(), -.25, rounding);
}

TEST(MaterialPair, BodiesChangeRolesButForTheSignOfTheCoupling) {
    const Material a{2.5, .25}, b{7, .4};
    const MaterialPair ab(a, b), ba(b, a);
    EXPECT_NEAR(ab.effective_modulus() / ba.effective_modulus(), 1, 2 * rounding);
    EXPECT_NEAR(ab.effective_shear_modulus() / ba.effective_shear_modulus(), 1, 2 * rounding);
    EXPECT_NEAR(ab.dundurs_beta(), -ba.dundurs_beta(), rounding);
    EXPECT_GT(std::abs(ab.dundurs_beta()), .01);
}

TEST(MaterialPair, IdenticalBodiesDoNotCouple) {
    for (const double nu : {-.3, 0., .3, .5}) {
        const MaterialPair pair(Material{2.1e11, nu}, {2.1e11, nu});
        EXPECT_EQ(pair.dundurs_beta(), 0) << nu;
        const MaterialPair rigid({}, {2.1e11, nu});
        EXPECT_NEAR(rigid.effective_modulus() / pair.effective_modulus(), 2, 4 * rounding) << nu;
    }
}

// G = (1/G1 + 1/G2)^-1 and nu = G (nu1/G1 + nu2/G2) (thesis 2.1.12): one body with these constants
// is as compliant as both.
TEST(MaterialPair, EquivalentSingleBody) {
    const Material a{2.5, .25}, b{7, .4};
    const MaterialPair pair(a, b);
    const double g = 1 / (1 / a.shear_modulus() + 1 / b.shear_modulus());
    const double nu = g * (a.poisson / a.shear_modulus() + b.poisson / b.shear_modulus());
    const MaterialPair single({}, {2 * g * (1 + nu), nu});
    EXPECT_NEAR(single.effective_modulus() / pair.effective_modulus(), 1, 4 * rounding);
    EXPECT_NEAR(single.effective_shear_modulus() / pair.effective_shear_modulus(), 1, 4 * rounding);
    EXPECT_NEAR(single.nu_over_g() / pair.nu_over_g(), 1, 4 * rounding);
}

TEST(MaterialPair, SteelOnRubber) {
    const MaterialPair pair(Material{206e9, .3}, {5.2e6, .5});
    // by hand: the steel adds 0.7/(2 * 79.23 GPa) to 1/E* = 0.5/(2 * 1.7333 MPa)
    EXPECT_NEAR(pair.effective_modulus(), 6.933121e6, 1);
    EXPECT_NEAR(pair.dundurs_beta(), -8.75e-6, 1e-8);
}

std::string message_of(std::optional<Material> indenter, Material substrate) {
    try {
        const MaterialPair pair(indenter, substrate);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(MaterialPair, RefusesImpossibleMaterials) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double young : {0., -1., nan, -infinity})
        EXPECT_EQ(message_of({}, {young, .3}), "substrate: Young's modulus must be positive")
            << young;
    for (const double poisson : {-1., .5000001, nan, infinity})
        EXPECT_EQ(message_of({}, {1, poisson}), "substrate: Poisson's ratio must lie in (-1, 0.5]")
            << poisson;
    EXPECT_EQ(message_of(Material{1, .6}, {1, .3}),
              "indenter: Poisson's ratio must lie in (-1, 0.5]");
    EXPECT_EQ(message_of(Material{1, .5}, {1, -.9999}), "no error");
    EXPECT_EQ(message_of({}, contact::rigid_material), "both bodies are rigid; one has to deform");
}

// Either body may be the rigid one: moduli are the same, and the coupling changes its sign with the
// side on which the other body lies.
TEST(MaterialPair, MayHaveARigidSubstrate) {
    const Material rubber{2e6, .3};
    const MaterialPair below({}, rubber), above(rubber, contact::rigid_material);
    EXPECT_EQ(above.effective_modulus(), below.effective_modulus());
    EXPECT_EQ(above.effective_shear_modulus(), below.effective_shear_modulus());
    EXPECT_EQ(above.nu_over_g(), below.nu_over_g());
    EXPECT_EQ(above.dundurs_beta(), -below.dundurs_beta());
}

}  // namespace
}  // namespace tricontact::material_test
