#include "atlas/contact_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "atlas/shipped.h"
#include "contact/base/error.h"
#include "contact/bodies/indenter.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/layer/elastic_layer.h"
#include "theory/rolling/mapped_strength.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::atlas::contact_maps_test {
namespace {

constexpr double along = 0, across = std::numbers::pi / 2;

template <class F>
std::string refusal_of(F call) {
    try {
        call();
    } catch (const OutsideDomain& error) {
        return error.what();
    }
    return "accepted";
}

// Boundary elements on a grid of 0.2 mm, 22 cells per radius; a second program agrees to 5 digits.
TEST(ContactMaps, HalfSpaceAgreesWithPublishedRuns) {
    struct Run {
        double w, f, u_stat, u_along, u_across;
    };
    const Run runs[] = {{.24, .24, .1671, .20149, .20930},
                        {.24, .56, .4208, .55940, .58237},
                        {.51, .09, .0609, .09656, .10576},
                        {.51, .24, .1671, .30097, .32984}};
    // Cells of that grid: 3e-3 of the shift.
    const auto expect_run = [](const Value& read, double run) {
        EXPECT_NEAR(read.value, run, read.error + 3e-3 * run);
        EXPECT_LT(read.error, 3e-3 * run);
    };
    for (const auto& [w, f, u_stat, u_along, u_across] : runs) {
        SCOPED_TRACE(testing::Message() << "w = " << w << ", f = " << f);
        expect_run(static_shift_ratio(f, .5), u_stat);
        expect_run(settled_shift_ratio(w, f, along, .5), u_along);
        expect_run(settled_shift_ratio(w, f, across, .5), u_across);
    }
}

TEST(ContactMaps, KappaIsThatOfTheSettledShift) {
    for (const double angle : {along, .7, across}) {
        const double w = .4, f = .3;
        const Value u = settled_shift_ratio(w, f, angle, .3);
        const Value kappa = mapping_parameter(w, f, angle, .3);
        const double slope = theory::mapping_parameter(w, f, u.value + u.error) -
                             theory::mapping_parameter(w, f, u.value);
        EXPECT_NEAR(kappa.value, theory::mapping_parameter(w, f, u.value),
                    kappa.error + std::abs(slope));
    }
}

TEST(ContactMaps, HalfSpaceHasItsLimits) {
    // Without Poisson's ratio Cattaneo and Mindlin are exact.
    for (const double f : {.05, .3, .6, .9}) {
        const Value u = static_shift_ratio(f, 0);
        EXPECT_NEAR(u.value, theory::static_shift_ratio(f), u.error + 1e-3 * u.value) << f;
        // Small amplitudes add little, in proportion.
        const Value settled = settled_shift_ratio(.02, f, along, 0);
        EXPECT_GT(settled.value, u.value - u.error);
        EXPECT_LT(settled.value, u.value * 1.06) << f;
    }
    const double least = settled_shift_ratio(.3, .4, along, .5).value;
    EXPECT_LT(least, settled_shift_ratio(.3, .4, across, .5).value);
    // MDR, whose springs are independent, settles farther.
    EXPECT_LT(least, *theory::settled_shift_ratio(.3, .4));
}

// Where closed forms are exact: nu = 0 at rest, the ends of the load, and between kappa and u_sd.
TEST(ContactMaps, AShearStrengthHasItsLimits) {
    const auto& law = theory::strength_rolling;
    for (const double f : {.1, .4, .8}) {
        const Value u = strength_static_shift_ratio(f, 0);
        EXPECT_NEAR(u.value, law.static_shift(f), u.error + 1e-3 * u.value) << f;
    }
    for (const double w : {.3, .5, .7}) {
        const double limit = law.exact_limit(w);
        // The flat punch of a lens, whose ellipse stands for it within 5e-3.
        const Value small = strength_mapping_parameter(w, .08 * limit, along, 0);
        EXPECT_NEAR(small.value, theory::small_load_mapping(w, law), small.error + 8e-3) << w;
        for (const double angle : {along, across}) {
            const double f = .96 * limit;
            const Value u = strength_settled_shift_ratio(w, f, angle, .5);
            EXPECT_LT(u.value, theory::largest_strength_shift_ratio({w, 0, angle, .5}) + u.error);
            const Value kappa = strength_mapping_parameter(w, f, angle, .5);
            const double slope = law.mapping_parameter(w, f, u.value + u.error) -
                                 law.mapping_parameter(w, f, u.value);
            // Two maps with bars of 95 % each, both at the end of their domain.
            EXPECT_NEAR(kappa.value, law.mapping_parameter(w, f, u.value),
                        2 * (kappa.error + std::abs(slope)));
            EXPECT_LT(kappa.value, law.mdr_mapping);
        }
    }
    EXPECT_EQ(refusal_of([] { strength_settled_shift_ratio(.9, .01, along, .5); }),
              "rolling.amplitude_ratio = 0.9: atlas sphere_half_space_strength goes from 0.1 to "
              "0.85");
}

TEST(ContactMaps, RatchetingOnAThickLayerIsThatOfTheHalfSpace) {
    constexpr BondedLayer thick{.thickness_ratio = 40, .poisson = .5, .friction_coefficient = 1};
    const double unit = pressed_layer_ratios(40, .5).unit_shift.value;
    for (const double angle : {along, .7, across})
        for (const double f : {.6, .8}) {
            const Value layer = shift_increment_ratio(.5, f, angle, thick);
            const Value half_space = shift_increment_ratio(.5, f, angle, .5);
            // Lengths: U_max of the layer is 0.4 % less. Both ends of two domains, twice their
            // bars.
            EXPECT_NEAR(layer.value * unit, half_space.value, 2 * (layer.error + half_space.error))
                << "f = " << f << ", angle " << angle;
            EXPECT_LT(layer.error, .04 * layer.value);
        }
    EXPECT_EQ(refusal_of([] {
                  shift_increment_ratio(.5, .8, along, {1, .4, 1});
              }),
              "substrate.poisson = 0.4: atlas sphere_layer_ratcheting is about 0.5");
}

TEST(ContactMaps, AnglesAreThoseOfTwoLines) {
    const double value = settled_shift_ratio(.3, .4, .5, .5).value;
    for (const double angle : {-.5, std::numbers::pi - .5, std::numbers::pi + .5})
        EXPECT_NEAR(settled_shift_ratio(.3, .4, angle, .5).value, value, 1e-12);  // rounding
}

TEST(ContactMaps, OutsideIsRefusedByKeyAndRange) {
    EXPECT_EQ(refusal_of([] { settled_shift_ratio(.9, .01, along, .5); }),
              "rolling.amplitude_ratio = 0.9: atlas sphere_half_space goes from 0.02 to 0.85");
    const double beyond = 1.1 * theory::shakedown_limit(.24);  // ratcheting
    EXPECT_EQ(refusal_of([=] { settled_shift_ratio(.24, beyond, along, .5); }),
              "load.limit_fraction = 1.1: atlas sphere_half_space goes from 0.02 to 0.99");
    EXPECT_EQ(refusal_of([] { mapping_parameter(.24, .3, across, -.1); }),
              "substrate.poisson = -0.1: atlas sphere_half_space goes from 0 to 0.5");
    EXPECT_EQ(refusal_of([] { pressed_layer_ratios(.1, .5); }),
              "substrate.thickness_ratio = 0.1: atlas sphere_layer_pressed goes from 0.25 to 40");
    const double nan = std::nan("");
    for (const auto& call : {+[](double x) { settled_shift_ratio(x, .3, along, .5); },
                             +[](double x) { settled_shift_ratio(.24, x, along, .5); },
                             +[](double x) { settled_shift_ratio(.24, .3, x, .5); },
                             +[](double x) { settled_shift_ratio(.24, .3, along, x); }})
        for (const double x : {nan, HUGE_VAL}) EXPECT_NE(refusal_of([=] { call(x); }), "accepted");
}

TEST(ContactMaps, PressedLayerAgreesWithItsTable) {
    struct Row {
        double thickness_ratio, a, d, p0, u_max;
    };
    const Row table[] = {{.25, .790, .304, 1.858, .858},  {.5, .909, .476, 1.267, .849},
                         {.889, .969, .637, 1.073, .875}, {1, .976, .669, 1.054, .883},
                         {2, .996, .819, 1.008, .931},    {4, .9995, .907, 1.001, .964},
                         {10, 1.000, .963, 1.000, .985}};
    for (const Row& row : table) {
        const PressedRatios r = pressed_layer_ratios(row.thickness_ratio, .5);
        const double rounding = .5e-3 + 2e-5;  // three digits, and the map
        EXPECT_NEAR(r.contact_radius.value, row.a, rounding) << row.thickness_ratio;
        EXPECT_NEAR(r.indentation.value, row.d, rounding) << row.thickness_ratio;
        EXPECT_NEAR(r.peak_pressure.value, row.p0, rounding) << row.thickness_ratio;
        EXPECT_NEAR(r.unit_shift.value, row.u_max, rounding) << row.thickness_ratio;
    }
}

TEST(ContactMaps, PressedLayerIsTheExactOne) {
    const double radius = .03, young = 2e6, force = 3;
    for (const double poisson : {0., .2, .37, .5})
        for (const double ratio : {.25, .31, .7, 1.6, 5., 25., 40.}) {
            SCOPED_TRACE(testing::Message() << "nu = " << poisson << ", b/D_c = " << ratio);
            const contact::Material material{young, poisson};
            const double modulus = young / (1 - poisson * poisson);
            const double a = std::cbrt(.75 * force * radius / modulus), d = a * a / radius;
            const double shear = young / (2 * (1 + poisson));
            const double unit = d * modulus * (2 - poisson) / (4 * shear);
            const double p0 = 1.5 * force / (std::numbers::pi * a * a);
            const auto exact = theory::solve_layer_contact(
                {material, ratio * 2 * a, theory::LayerBase::bonded}, contact::Paraboloid(radius),
                {contact::NormalControl::Kind::force, force});
            const PressedRatios r = pressed_layer_ratios(ratio, poisson);
            EXPECT_NEAR(r.contact_radius.value * a / exact.contact_radius, 1, 1e-4);
            EXPECT_NEAR(r.indentation.value * d / exact.indentation, 1, 1e-4);
            EXPECT_NEAR(r.peak_pressure.value * p0 / exact.centre_pressure, 1, 1e-4);
            EXPECT_NEAR(r.unit_shift.value * unit / *exact.unit_shift, 1, 1e-4);
            for (const double w : {.05, .3, .6}) {
                const Value limit = layer_shakedown_limit(w, ratio, poisson);
                EXPECT_NEAR(limit.value, theory::shakedown_limit(exact, w), 1e-4) << w;
            }
        }
}

TEST(ContactMaps, ThickLayersAreHalfSpaces) {
    const PressedRatios r = pressed_layer_ratios(40, .3);
    EXPECT_NEAR(r.contact_radius.value, 1, 1e-4);
    EXPECT_NEAR(r.peak_pressure.value, 1, 1e-4);
    // d lacks h0 a/(pi b) times a number: 1 % at forty diameters.
    EXPECT_LT(std::abs(r.indentation.value - 1), 1e-2);
    EXPECT_NEAR(layer_shakedown_limit(.4, 40, .3).value, theory::shakedown_limit(.4), 1e-4);
}

// Two boundary element programs on the rig's layer, b = 8 mm, mu = 0.57, pressed in one step.
TEST(ContactMaps, LayerAgreesWithPublishedRuns) {
    const BondedLayer rig{
        .thickness_ratio = 8 / (2 * 4.5028), .poisson = .5, .friction_coefficient = .57};
    struct Run {
        double w, f, u_along, u_across;
    };
    // Their third point, w = 0.51, is beyond the atlas.
    // The way of pressing changes shifts by 1 %: the atlas' layers are pressed in 20 steps.
    for (const auto& [w, f, u_along, u_across] :
         {Run{.24, .24, .1990, .2085}, Run{.24, .56, .5648, .5921}}) {
        EXPECT_NEAR(settled_shift_ratio(w, f, along, rig).value / u_along, 1, 2e-2);
        EXPECT_NEAR(settled_shift_ratio(w, f, across, rig).value / u_across, 1, 2e-2);
    }
    // U_stat at f = 0.56: 0.15155 mm of U_max = 0.37912 mm.
    EXPECT_NEAR(static_shift_ratio(.56, rig).value / (.15155 / .37912), 1, 5e-3);
}

// Boundary elements of this program and of a second one in steps of 0.2 mm; extrapolated to no
// steps along the load, by 1 % at most across it.
TEST(ContactMaps, RatchetingAgreesWithPublishedRuns) {
    struct Run {
        double w, f, along, across;
    };
    for (const Run& run : {Run{.24, .80, .159, .2237}, Run{.51, .72, .465, .6434}}) {
        const Value increment = shift_increment_ratio(run.w, run.f, along, .5);
        EXPECT_NEAR(increment.value, run.along, increment.error + 3e-3 * run.along);
        EXPECT_LT(increment.error, 3e-2 * run.along);
        EXPECT_NEAR(shift_increment_ratio(run.w, run.f, across, .5).value / run.across, 1, 1e-2);
    }
}

// MDR in 60 steps per quarter of a period: first order, 0.6 % below no steps.
TEST(ContactMaps, RatchetingOfMdrAgreesWithPublishedRuns) {
    const double runs[][3] = {
        {.24, .80, .4031}, {.51, .72, 1.0889}, {.74, .72, 1.6748}, {.51, .90, 1.9403}};
    for (const auto& [w, f, published] : runs) {
        const Value increment = mdr_shift_increment_ratio(w, f);
        EXPECT_GT(increment.value, published) << w;
        EXPECT_LT(increment.value, published * 1.008) << w;
    }
}

TEST(ContactMaps, MapsOfMdrAreThoseOfItsLoad) {
    const double w = .3, f = .4, u = *theory::settled_shift_ratio(w, f);
    EXPECT_NEAR(settled_shift_of_mdr(u, w, .5, .3).value, settled_shift_ratio(w, f, .5, .3).value,
                1e-9);
    EXPECT_THROW(settled_shift_of_mdr(1 - w * w, w, 0, .3), std::domain_error);
    EXPECT_THROW(settled_shift_of_mdr(0, w, 0, .3), std::domain_error);
    const double beyond = .8;
    const double increment = mdr_shift_increment_ratio(w, beyond).value;
    EXPECT_NEAR(shift_increment_of_mdr(increment, w, .5, .3).value,
                shift_increment_ratio(w, beyond, .5, .3).value, 1e-9);
    EXPECT_THROW(shift_increment_of_mdr(10, w, .5, .3), OutsideDomain);
}

TEST(ContactMaps, ThreadsReadTheSame) {
    const auto sum = [] {
        double s = 0;
        for (int i = 0; i < 200; ++i) s += settled_shift_ratio(.1 + .003 * i, .02, .5, .3).value;
        return s;
    };
    std::vector<double> sums(4);
    {
        std::vector<std::jthread> threads;
        for (double& s : sums) threads.emplace_back([&s, sum] { s = sum(); });
    }
    for (const double s : sums) EXPECT_EQ(s, sum());
}

}  // namespace
}  // namespace tricontact::atlas::contact_maps_test
