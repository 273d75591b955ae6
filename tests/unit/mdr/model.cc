#include "mdr/model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "mdr/spring_bed.h"
#include "tests/verification/mdr/roller.h"

namespace tricontact::model_test {
namespace {

using mdr_test::Roller;
using mdr_test::sphere_rig;

const mdr::SpringBed& bed_of(Roller& roller) {
    return dynamic_cast<const mdr::SpringBed&>(roller.model());
}

TEST(MdrModel, BedIsAsLongAsThePath) {
    for (const auto reference :
         {contact::Case::AmplitudeReference::hertz, contact::Case::AmplitudeReference::model}) {
        contact::Case c = sphere_rig(.7, .2, 1000, 6);
        c.rolling->amplitude_reference = reference;
        Roller roller(c);
        roller.roll(2);
        const auto& bed = bed_of(roller).normal();
        EXPECT_EQ(bed.size(), 1000);  // had no need to grow
        const double needed = 1.7 * contact::half_space_scales(c).contact_radius;
        EXPECT_NEAR(bed.spacing() * 500 / needed, 1.01, 1e-9);
    }
}

TEST(MdrModel, BedFitsAnOscillatingNormalForce) {
    contact::Case c = sphere_rig(.3, .1, 1000, 6);
    c.load.normal_amplitude_ratio = .6;
    c.load.normal_phase = .7;
    Roller roller(c);
    roller.roll(2);
    EXPECT_EQ(bed_of(roller).normal().size(), 1000);
    EXPECT_TRUE(roller.model().audit().passed());
}

TEST(MdrModel, ExactSphereFollowsItsOwnTransform) {
    contact::Case c = sphere_rig(.3, .2, 10000, 6);
    c.indenter.shape = contact::Case::Shape::sphere;
    c.load.normal_force = 2000;  // a/R about .5: far from the paraboloid
    Roller roller(c);
    const double radius = c.indenter.radius, a = roller.scales().contact_radius;
    EXPECT_NEAR(roller.scales().indentation, a * std::atanh(a / radius), 1e-12 * a);
    // F_N = 2 E* ∫_0^a (g(a) - g) dx = E* [ (R^2 + a^2)/2 ln((R+a)/(R-a)) - R a ]
    const double force = c.materials().effective_modulus() *
                         ((radius * radius + a * a) * std::atanh(a / radius) - radius * a);
    EXPECT_NEAR(roller.scales().normal_force / force, 1, 1e-7);  // dx^2/4, dx = 2.6e-4 a
    // pi p0/E* = ∫_0^a g'/x dx, midpoint sum of g' = atanh(x/R) + x R/(R^2 - x^2)
    double integral = 0;
    constexpr int n = 20000;
    for (int k = 0; k < n; ++k) {
        const double x = a * (k + .5) / n;
        integral += (std::atanh(x / radius) / x + radius / (radius * radius - x * x)) * a / n;
    }
    const double peak = c.materials().effective_modulus() / std::acos(-1.) * integral;
    EXPECT_NEAR(roller.scales().peak_pressure / peak, 1, 1e-8);
    roller.roll(3);
    EXPECT_TRUE(roller.model().audit().passed());
}

TEST(MdrModel, IndentationControl) {
    contact::Case c = sphere_rig(.24, .56, 4000, 6);
    const double depth = contact::half_space_scales(c).indentation;
    const double by_force = Roller(c).roll(20).shift_ratio();
    c.load.normal_force.reset();
    c.load.indentation = depth;
    // the discrete force differs from Hertz' by dx^2 = 4e-7
    EXPECT_NEAR(Roller(c).roll(20).shift_ratio(), by_force, 2e-6);
}

TEST(MdrModel, PressingBeyondTheRimIsRefused) {
    contact::Case c = sphere_rig(.24, .5, 1000, 6);
    c.indenter.shape = contact::Case::Shape::sphere;
    c.load.normal_force = 2e5;
    EXPECT_THROW(mdr::make_model(c), contact::InputError);
}

}  // namespace
}  // namespace tricontact::model_test
