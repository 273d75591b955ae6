#include "experiments/identification/interface_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/model_makers.h"
#include "experiments/identification/interface_parameters.h"
#include "tests/random/spring_rig.h"

namespace tricontact::experiments::interface_comparison_test {
namespace {

using Measurement = IdentificationInput::Measurement;

constexpr double young = 2e6, friction = .7, stiffness = 20e9;

/// Tables that rings make, with noise of 0.2 % of their largest values.
IdentificationInput measured(const SpringRig& rig, const std::vector<std::string>& find) {
    IdentificationInput input;
    IdentificationInput::Table shifts{.measurement = Measurement::static_shift},
        depths{.measurement = Measurement::force_indentation};
    for (const double load : {.05, .2, .8}) {
        std::vector<double> forces;
        for (int k = 1; k <= 6; ++k) forces.push_back(.15 * k * friction * load);
        for (const double shift : rig.shifts(load, forces)) shifts.observed.push_back(shift);
        shifts.given.insert(shifts.given.end(), forces.begin(), forces.end());
        shifts.normal_forces.insert(shifts.normal_forces.end(), forces.size(), load);
    }
    const double deepest = rig.under(.8).depth;
    for (int k = 1; k <= 10; ++k) {
        depths.given.push_back(.1 * k * deepest);
        depths.observed.push_back(rig.load_at_depth(depths.given.back()));
    }
    std::mt19937 random(46);
    std::normal_distribution<double> gauss(0, .002);
    for (auto* table : {&shifts, &depths}) {
        const double largest = *std::max_element(table->observed.begin(), table->observed.end());
        for (double& value : table->observed) value += gauss(random) * largest;
        input.tables.push_back(*table);
    }
    input.models = {"half-space"};
    input.rig.indenter.radius = rig.radius;
    input.rig.substrate = {1.4e6, .5};
    input.rig.friction.coefficient = 1;
    input.rig.load.normal_force = .8;
    input.rig.interface = {stiffness, stiffness};
    input.parameters = free_parameters(input, find);
    return input;
}

const std::vector<std::string> everything{"substrate.young", "friction.coefficient",
                                          normal_stiffness_key, tangential_stiffness_key};

double number(const InterfaceFit& fit, const char* key) {
    return fit.found.parameters[*fit.found.find(key)].value;
}

TEST(InterfaceComparison, SpringsAreFoundAndARigidInterfaceIsExcluded) {
    const SpringRig rig{10e-3, young, 1 / stiffness, 2 / stiffness,
                        [](double p) { return friction * p; }};
    const contact::ModelMakers makers;
    const auto found = compare_interfaces(measured(rig, everything), {makers, 1});
    ASSERT_EQ(found.fits.size(), 4U);
    EXPECT_EQ(found.fits[0].name, "rigid");
    EXPECT_EQ(found.fits[1].name, "k_n");
    EXPECT_EQ(found.fits[2].name, "k_t");
    EXPECT_EQ(found.fits[3].name, "k_n, k_t");
    EXPECT_EQ(found.best, 3U);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(found.fits[i].is_excluded) << i;
    EXPECT_FALSE(found.fits[3].is_excluded);
    // Intervals of 95 % are 1 % and 15 % wide.
    EXPECT_NEAR(number(found.fits[3], "substrate.young") / young, 1, .01);
    EXPECT_NEAR(number(found.fits[3], "friction.coefficient") / friction, 1, .01);
    EXPECT_NEAR(number(found.fits[3], normal_stiffness_key) / stiffness, 1, .15);
    EXPECT_NEAR(number(found.fits[3], tangential_stiffness_key) / (stiffness / 2), 1, .15);
    // A rigid one is taken for a softer substrate.
    EXPECT_LT(number(found.fits[0], "substrate.young"), .97 * young);
    for (int i = 0; i < 3; ++i) EXPECT_GT(found.fits[i].likelihood_ratio, 10) << i;
}

// Where there are none, intervals are open, and a rigid interface is as good.
TEST(InterfaceComparison, RigidInterfacesLeaveIntervalsOpen) {
    const SpringRig rig{10e-3, young, 0, 0, [](double p) { return friction * p; }};
    const contact::ModelMakers makers;
    const auto found = compare_interfaces(measured(rig, everything), {makers, 1});
    EXPECT_FALSE(found.fits.front().is_excluded);
    const auto& all = found.fits.back().found;
    for (const char* key : {normal_stiffness_key, tangential_stiffness_key}) {
        const Interval interval = all.parameters[*all.find(key)].likelihood;
        EXPECT_TRUE(std::isinf(interval.high)) << key;
        EXPECT_GT(interval.low, 3 * stiffness) << key;
    }
}

}  // namespace
}  // namespace tricontact::experiments::interface_comparison_test
