#include "mdr/plane_profile.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <vector>

#include "contact/base/error.h"
#include "tests/unit/mdr/profiles.h"

namespace tricontact::plane_profile_test {
namespace {

using mdr::PowerLawProfile;
using mdr::TabulatedProfile;

TEST(MdrPlaneProfile, ParaboloidUsesTheClosedForm) {
    const auto profile = mdr::make_plane_profile(contact::Paraboloid(.04), .01);
    const double a = 3e-3, d = a * a / .04;
    EXPECT_NEAR(profile->value(-a), d, 1e-15 * d);
    EXPECT_NEAR(profile->half_width(d), a, 1e-15);
    EXPECT_NEAR(profile->half_width_of_area(4. / 3 * std::sqrt(.04) * std::pow(d, 1.5)), a, 1e-15);
    EXPECT_NEAR(profile->centre_integral(a) / (2 * std::sqrt(d / .04)), 1, 1e-14);  // pi p0/E*
}

TEST(MdrPlaneProfile, SamplesAreValues) {
    const PowerLawProfile quadratic(12, 2), cubic(12, 3);
    const TabulatedProfile sphere(contact::Sphere(.04), .02);
    for (const mdr::PlaneProfile* profile :
         std::initializer_list<const mdr::PlaneProfile*>{&quadratic, &cubic, &sphere}) {
        std::vector<double> heights(41);
        profile->sample(-.011, 5.3e-4, heights);
        for (int i = 0; i < 41; ++i) EXPECT_EQ(heights[i], profile->value(-.011 + i * 5.3e-4));
    }
    EXPECT_TRUE(std::isinf(sphere.value(.0201)));
}

TEST(MdrPlaneProfile, TableOfTheSphere) {
    const double radius = .04;
    const TabulatedProfile table(contact::Sphere(radius), .999 * radius);
    for (int k = 1; k < 3996; ++k) {
        const double x = radius * k / 4000.;
        // series and quadrature to 1e-12 each
        EXPECT_NEAR(table.value(x) / mdr_test::transformed_sphere(radius, x), 1, 1e-12) << k;
    }
    const double a = .031;
    auto height = [&](double x) { return mdr_test::transformed_sphere(radius, x); };
    boost::math::quadrature::tanh_sinh<double> quadrature;
    const double area = quadrature.integrate(height, 0., a);
    EXPECT_NEAR(table.integral(a) / area, 1, 1e-12);
    auto slope_over_x = [&](double x) {  // g'/x
        return std::log((radius + x) / (radius - x)) / (2 * x) + radius / (radius * radius - x * x);
    };
    EXPECT_NEAR(table.centre_integral(a) / quadrature.integrate(slope_over_x, 0., a), 1, 1e-11);
    EXPECT_NEAR(table.half_width(height(a)) / a, 1, 1e-12);
    EXPECT_NEAR(table.half_width_of_area(2 * (a * height(a) - area)) / a, 1, 1e-12);
}

TEST(MdrPlaneProfile, TableOfAPowerLawIsItsClosedForm) {
    for (const double n : {1.5, 4.}) {
        const TabulatedProfile table(mdr_test::PowerLawIndenter(3, n), .2);
        const PowerLawProfile closed(3, n);
        for (const double x : {.01, .05, .123, .2})
            EXPECT_NEAR(table.value(x) / closed.value(x), 1, 1e-11) << n << ' ' << x;
        EXPECT_NEAR(table.integral(.15) / closed.integral(.15), 1, 1e-12);
        // x^(n - 2) at zero is integrated on bisected panels
        EXPECT_NEAR(table.centre_integral(.15) / closed.centre_integral(.15), 1, 1e-5) << n;
    }
}

TEST(MdrPlaneProfile, TableWithAKink) {
    const mdr_test::TwoCones indenter(.2, 1.1, .01);
    const TabulatedProfile table(indenter, .1);
    for (int k = 1; k < 5000; ++k) {
        const double x = .1 * (k - .5) / 5000.;
        EXPECT_NEAR(table.value(x) / indenter.transformed(x), 1, 2e-11) << x;
    }
    EXPECT_TRUE(std::isinf(table.centre_integral(.05)));  // conical tip
    EXPECT_TRUE(std::isinf(PowerLawProfile(1, 1).centre_integral(.05)));
}

TEST(MdrPlaneProfile, RefusesWhatIsNoProfile) {
    // Steep inside, flat outside: a ring of the bed would be free inside the contact.
    EXPECT_THROW(TabulatedProfile(mdr_test::TwoCones(1.1, 0, .01), .1), contact::InputError);
    EXPECT_THROW(TabulatedProfile(mdr_test::SawTooth(30), 1), contact::InputError);
    EXPECT_THROW(TabulatedProfile(contact::Sphere(.04), .05), std::domain_error);
    EXPECT_THROW(TabulatedProfile(contact::Sphere(.04), 0), std::domain_error);
    EXPECT_THROW(PowerLawProfile(-1, 2), std::domain_error);
    EXPECT_THROW(PowerLawProfile(1, 2).half_width(0), std::domain_error);
    EXPECT_THROW(PowerLawProfile(1, 2).half_width_of_area(-1), std::domain_error);
}

TEST(MdrPlaneProfile, SaysWhenTheRimIsReached) {
    const TabulatedProfile table(contact::Sphere(.04), .01);
    try {
        table.half_width(1.01 * table.value(.01));
        FAIL() << "no error";
    } catch (const contact::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "indenter: the contact reaches the rim of its profile at 0.01 m; reduce the "
                     "load or enlarge the indenter");
    }
    EXPECT_THROW(table.half_width_of_area(1), contact::InputError);
}

}  // namespace
}  // namespace tricontact::plane_profile_test
