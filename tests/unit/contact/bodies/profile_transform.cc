#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "contact/base/error.h"
#include "contact/bodies/indenter.h"
#include "contact/bodies/shapes_of_revolution.h"
#include "tests/unit/mdr/profiles.h"

namespace tricontact::profile_transform_test {
namespace {

using std::numbers::pi;

TEST(ProfileTransform, PowerLawFactors) {
    EXPECT_NEAR(contact::power_law_factor(1), pi / 2, 1e-14);
    EXPECT_NEAR(contact::power_law_factor(2), 2, 1e-14);
    EXPECT_NEAR(contact::power_law_factor(3), 3 * pi / 4, 1e-14);
    EXPECT_NEAR(contact::power_law_factor(4), 8. / 3, 1e-14);
    EXPECT_NEAR(contact::power_law_factor(400) / std::sqrt(200 * pi), 1, 1e-3);  // Stirling
    for (const double n : {.9, -1., std::nan("")})
        EXPECT_THROW(contact::power_law_factor(n), std::domain_error);
}

TEST(ProfileTransform, QuadratureGivesPowerLaws) {
    for (const double n : {1., 1.5, 2., 3.7, 10.}) {
        const mdr_test::PowerLawIndenter indenter(0.7, n);
        for (const double x : {1e-6, .3, 2.}) {
            const double exact = 0.7 * contact::power_law_factor(n) * std::pow(x, n);
            // quadrature to 1e-13; n = 1.5 has a square root at its end
            EXPECT_NEAR(indenter.plane_profile(x) / exact, 1, 1e-12) << n << ' ' << x;
        }
    }
    EXPECT_EQ(mdr_test::PowerLawIndenter(1, 2).plane_profile(0), 0);
}

TEST(ProfileTransform, QuadratureGivesTheSphere) {
    const contact::Sphere sphere(0.04);
    for (const double part : {1e-6, .1, .5, .9, .999, .999999}) {
        const double exact = mdr_test::transformed_sphere(0.04, part * 0.04);
        // toward the equator 1 - x/R loses digits in the closed form itself: 1e-16/(1 - x/R)
        EXPECT_NEAR(sphere.plane_profile(part * 0.04) / exact, 1, 1e-12 + 1e-16 / (1 - part))
            << part;
    }
}

TEST(ProfileTransform, KinksSplitTheIntegral) {
    for (const double inner : {0., 0.2, 0.9}) {
        const mdr_test::TwoCones indenter(inner, 1.1, 0.01);
        for (const double x : {.005, .01, .010001, .012, .03, .0999})
            // acos(b/x) just beyond the kink: 1e-16/sqrt(1 - b/x) in the closed form
            EXPECT_NEAR(indenter.plane_profile(x) / x, indenter.transformed(x) / x, 1e-11)
                << inner << ' ' << x;
    }
}

TEST(ProfileTransform, RefusesPositionsOutsideOfTheIndenter) {
    EXPECT_THROW(contact::Sphere(.04).plane_profile(.0401), std::domain_error);
    EXPECT_THROW(contact::Sphere(.04).plane_profile(std::nan("")), std::domain_error);
}

TEST(ProfileTransform, RefusesKinksThatAreNotDeclared) {
    try {
        mdr_test::SawTooth(7).plane_profile(.9);
        FAIL() << "no error";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("declare its kinks"), std::string::npos);
    }
}

}  // namespace
}  // namespace tricontact::profile_transform_test
