#include "atlas/line_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "theory/oscillating_cylinder.h"

namespace tricontact::atlas::line_maps_test {
namespace {

// An incompressible layer of forty contact widths under a contact of little friction by coupling.
constexpr double thick = 40;
constexpr BondedLayer thick_layer{
    .thickness_ratio = thick, .poisson = .5, .friction_coefficient = 1};

// Far below the contact a layer adds to the shift of the half-space in proportion to the force: the
// logarithm of its length gives way to that of the thickness, and the rest stays.
TEST(LineMaps, OfAThickLayerAreThoseOfTheHalfSpaceWithItsOwnLogarithm) {
    const Value lambda = line_layer_shift_factor(thick, .5);
    const auto expect = [](const Value& read, double exact) {
        // (a/b)^2 of the compliance is left. Of fourteen bars of 95 % one may be too short.
        EXPECT_NEAR(read.value, exact, 2 * read.error + 1e-3 * exact);
        EXPECT_LT(read.error, .02 * exact);
    };
    for (const double f : {.1, .4, .7, .95}) {
        SCOPED_TRACE(f);
        expect(line_static_shift_ratio(f, thick_layer),
               theory::line_static_shift_ratio(f, lambda.value));
    }
    for (const double w : {.1, .25, .4}) {
        const double limit = theory::line_shakedown_limit(w);
        expect(line_layer_shakedown_limit(w, thick, .5), limit);
        for (const double share : {.2, .5, .75}) {
            SCOPED_TRACE(testing::Message() << "w = " << w << ", share " << share);
            const double c = *theory::line_stick_half_width(w, share * limit);
            expect(line_settled_shift_ratio(w, share * limit, thick_layer),
                   theory::line_settled_shift_ratio(w, c, lambda.value));
        }
    }
}

TEST(LineMaps, ThickLayersGiveWayByTheLogarithmOfTheirThickness) {
    for (const double poisson : {.3, .5}) {
        const Value thin = line_layer_shift_factor(15, poisson),
                    twice = line_layer_shift_factor(30, poisson);
        EXPECT_NEAR(twice.value - thin.value, std::log(2.), twice.error + thin.error + 1e-3);
    }
}

// Carter's rolling, to which each way between turning points comes at large loads, gives the slope
// of Delta u over w beyond w = 1; nearer to the limit it lies below.
TEST(LineMaps, RatchetingComesNearToCartersRolling) {
    const double f = .95, lambda = 5;
    const double slope = (line_shift_increment_ratio(.85, f, lambda).value -
                          line_shift_increment_ratio(.75, f, lambda).value) /
                         .1;
    EXPECT_NEAR(slope, theory::line_steady_slope(f, lambda), .03 * slope);
}

TEST(LineMaps, IncrementsGoWithTheInverseOfLambda) {
    const Value one = line_shift_increment_ratio(.5, .7, 3),
                two = line_shift_increment_ratio(.5, .7, 6);
    EXPECT_NEAR(one.value / two.value, 2, 1e-12);
    EXPECT_NEAR(one.error / two.error, 2, 1e-12);
    EXPECT_THROW(line_shift_increment_ratio(.5, .2, 3), OutsideDomain);  // settles
    EXPECT_THROW(line_shift_increment_ratio(1.2, .7, 3), OutsideDomain);
}

}  // namespace
}  // namespace tricontact::atlas::line_maps_test
