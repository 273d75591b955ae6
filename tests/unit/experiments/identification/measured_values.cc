#include "experiments/identification/measured_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"

namespace tricontact::measured_values_test {
namespace {

using contact::Case;
using experiments::IdentificationInput;
using Table = IdentificationInput::Table;
using Measurement = IdentificationInput::Measurement;

constexpr double radius = .04, young = 5.2e6, friction = .57, normal_force = 21.1;

Case rig() {
    Case c;
    c.indenter.radius = radius;
    c.substrate = {young, .5};
    c.friction.coefficient = friction;
    c.load.normal_force = normal_force;
    c.load.tangential_ratio = 0;
    return c;
}

/// A program without models: closed forms ask for none.
contact::ModelMakers no_models() {
    contact::ModelMakers makers;
    makers.make = [](const std::string& name, auto&&...) -> std::unique_ptr<contact::Model> {
        throw contact::InputError("no model is due, but " + name);
    };
    return makers;
}

std::vector<double> half_space_values(const Table& table, const experiments::IdentifiedRig& at,
                                      const std::vector<double>& given) {
    const contact::ModelMakers makers = no_models();
    return experiments::measured_values("half-space", table, at, given,
                                        contact::ModelRunner(makers, 1));
}

// E* = E/(1 - nu^2) = 4/3 E under a rigid sphere; d = (9 F^2/(16 E*^2 R))^(1/3), Hertz.
double depth(double force) {
    return std::cbrt(9 * force * force / (16 * std::pow(young * 4 / 3, 2) * radius));
}

TEST(MeasuredValues, OfTheHalfSpaceAreHertzAndCattaneo) {
    const std::vector<double> ratios{.1, .5, .9};
    std::vector<double> forces;
    for (const double f : ratios) forces.push_back(f * friction * normal_force);
    const auto shifts =
        half_space_values({.measurement = Measurement::static_shift}, {rig()}, forces);
    ASSERT_EQ(shifts.size(), 3U);
    // U = mu E*/G* d (1 - (1 - f)^(2/3)), E*/G* = (2 - nu)/(2 - 2 nu) = 3/2.
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(shifts[k] / (friction * 1.5 * depth(normal_force) *
                                 (1 - std::pow(1 - ratios[k], 2. / 3))),
                    1, 1e-12);
    const auto radii = half_space_values({.measurement = Measurement::contact_radius}, {rig()},
                                         {10., normal_force});
    EXPECT_NEAR(radii[1] / std::sqrt(radius * depth(normal_force)), 1, 1e-12);
    EXPECT_NEAR(radii[0] / radii[1], std::cbrt(10 / normal_force), 1e-12);
}

// Depths count from where the contact begins; before it there is no force.
TEST(MeasuredValues, NoForceBeforeContact) {
    const Table table{.measurement = Measurement::force_indentation, .has_free_zero = true};
    const double zero = 2e-4;
    const auto forces = half_space_values(table, {.as_case = rig(), .zero_depths = {zero}},
                                          {1e-4, zero, zero + depth(7), zero + depth(9)});
    EXPECT_EQ(forces[0], 0);
    EXPECT_EQ(forces[1], 0);
    EXPECT_NEAR(forces[2], 7, 1e-9);
    EXPECT_NEAR(forces[3], 9, 1e-9);
    EXPECT_THROW(half_space_values(table, {.as_case = rig(), .zero_depths = {zero}}, {1e-4}),
                 contact::InputError);
}

// Held at a depth the force follows G(t)/G_inf = 1 + g exp(-t/tau).
TEST(MeasuredValues, HeldForceRelaxesAsTheSeries) {
    Case c = rig();
    c.relaxation = contact::Relaxation{{{.8, .5}}, {}};
    const auto forces = half_space_values(
        {.measurement = Measurement::force_relaxation, .held = depth(12)}, {c}, {0, .5, 50});
    EXPECT_NEAR(forces[0], 12 * 1.8, 1e-9);
    EXPECT_NEAR(forces[1], 12 * (1 + .8 * std::exp(-1)), 1e-9);
    EXPECT_NEAR(forces[2], 12, 1e-9);
}

// A pivot above the contact drags the indenter by Dh/R of the way (Wetter 2016, 5.1.11).
TEST(MeasuredValues, ShiftsFollowTheDrive) {
    const auto shifts =
        half_space_values({.measurement = Measurement::rolling_shift, .given = {-1e-3, 2e-3}},
                          {.as_case = rig(), .pivot_height = 1e-3}, {-1e-3, 2e-3});
    EXPECT_NEAR(shifts[0], -1e-3 * 1e-3 / radius, 1e-18);
    EXPECT_NEAR(shifts[1], 2e-3 * 1e-3 / radius, 1e-18);
}

}  // namespace
}  // namespace tricontact::measured_values_test
