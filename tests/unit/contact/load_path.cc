#include "contact/load_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "contact/base/error.h"

namespace tricontact::load_path_test {
namespace {

using contact::Case;
using contact::LoadPath;
using std::numbers::pi;

// mu F_N = 10 N; Hertz radius 4 mm.
constexpr double friction = .5, normal_force = 20, model_radius = 4.4e-3;

Case rolling_case() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {3. / 4 * 20 / (4. / 3 * .2 * 8e-6), .5};  // E* = 4 E/3
    c.friction.coefficient = friction;
    c.load.normal_force = normal_force;
    c.load.tangential_ratio = .6;
    c.rolling.emplace();
    c.rolling->amplitude = 1.2e-3;
    return c;
}

LoadPath path_of(const Case& c) {
    return contact::make_load_path(c, normal_force, model_radius);
}

TEST(TriangleWave, GoesUpFirst) {
    const double values[][2] = {{0, 0},    {.125, .5}, {.25, 1},  {.5, 0},    {.625, -.5},
                                {.75, -1}, {1, 0},     {1.25, 1}, {-.25, -1}, {-.125, -.5}};
    for (const auto& [phase, value] : values)
        EXPECT_DOUBLE_EQ(contact::triangle_wave(phase), value) << phase;
}

TEST(LoadPath, PressesWithoutTangentialLoad) {
    const auto press = contact::press_step(rolling_case());
    EXPECT_EQ(press.phase, 0);
    EXPECT_EQ(press.offset, (contact::Vector2{0, 0}));
    EXPECT_EQ(press.normal.kind, contact::NormalControl::Kind::force);
    EXPECT_EQ(press.normal.value, normal_force);
    for (const auto& control : press.tangential) {
        EXPECT_EQ(control.kind, contact::TangentialControl::Kind::force);
        EXPECT_EQ(control.value, 0);
    }
}

TEST(LoadPath, StaticCaseOnlyLoads) {
    Case c = rolling_case();
    c.rolling.reset();
    const LoadPath path = path_of(c);
    ASSERT_EQ(path.loading.size(), 1u);
    EXPECT_DOUBLE_EQ(path.loading[0].tangential[0].value, 6);
    EXPECT_EQ(path.loading[0].tangential[1].value, 0);
    EXPECT_TRUE(path.period.empty());
    EXPECT_EQ(path.max_periods, 0);
}

TEST(LoadPath, TurningPoints) {
    Case c = rolling_case();
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 7;
    c.rolling->run_all = true;
    const LoadPath path = path_of(c);
    ASSERT_EQ(path.period.size(), 4u);
    const double positions[] = {1.2e-3, 0, -1.2e-3, 0};
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(path.period[k].phase, (k + 1) / 4.);
        EXPECT_EQ(path.period[k].offset[0], positions[k]);
        EXPECT_EQ(path.period[k].offset[1], 0);
        EXPECT_DOUBLE_EQ(path.period[k].tangential[0].value, 6);
        EXPECT_EQ(path.period[k].normal.value, normal_force);
    }
    EXPECT_EQ(path.max_periods, 7);
    EXPECT_TRUE(path.run_all);
    EXPECT_DOUBLE_EQ(path.amplitude, 1.2e-3);
}

TEST(LoadPath, StepsPerQuarterFollowTheTriangle) {
    Case c = rolling_case();
    c.rolling->steps_per_quarter = 6;
    const LoadPath path = path_of(c);
    ASSERT_EQ(path.period.size(), 24u);
    for (const auto& step : path.period)
        EXPECT_NEAR(step.offset[0], 1.2e-3 * contact::triangle_wave(step.phase), 1e-18);
    EXPECT_EQ(path.period.back().phase, 1);
    EXPECT_EQ(path.period.back().offset[0], 0);
    // The way back meets the very same positions: pressures need not be solved again.
    for (int k = 1; k < 6; ++k) {
        EXPECT_EQ(path.period[5 - k].offset, path.period[5 + k].offset) << k;
        EXPECT_EQ(path.period[17 - k].offset, path.period[17 + k].offset) << k;
    }
}

TEST(LoadPath, IncrementGivesEqualStepsNoLongerThanAsked) {
    Case c = rolling_case();
    c.rolling->steps = Case::Steps::increment;
    const double increments[][2] = {{.2e-3, 6}, {.25e-3, 5}, {1.2e-3, 1}, {5e-3, 1}, {.1e-3, 12}};
    for (const auto& [increment, in_quarter] : increments) {
        c.rolling->increment = increment;
        EXPECT_EQ(path_of(c).period.size(), 4 * in_quarter) << increment;
    }
}

TEST(LoadPath, AngleTurnsThePathOnly) {
    Case c = rolling_case();
    c.rolling->steps_per_quarter = 3;
    const LoadPath along = path_of(c);
    c.rolling->angle = pi / 2;
    const LoadPath across = path_of(c);
    c.rolling->angle = pi / 4;
    const LoadPath between = path_of(c);
    for (std::size_t k = 0; k < along.period.size(); ++k) {
        const double distance = along.period[k].offset[0];
        EXPECT_EQ(across.period[k].offset, (contact::Vector2{0, distance}));  // no 6e-17 in x
        EXPECT_NEAR(between.period[k].offset[0], distance / std::sqrt(2), 1e-18);
        EXPECT_NEAR(between.period[k].offset[1], distance / std::sqrt(2), 1e-18);
        EXPECT_EQ(across.period[k].tangential[0], along.period[k].tangential[0]);
        EXPECT_EQ(across.period[k].tangential[1].value, 0);
    }
}

TEST(LoadPath, AmplitudeRatioRefersToHertzOrToTheModel) {
    Case c = rolling_case();
    c.rolling->amplitude.reset();
    c.rolling->amplitude_ratio = .3;
    EXPECT_NEAR(path_of(c).amplitude, .3 * 4e-3, 1e-16);
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    EXPECT_NEAR(path_of(c).amplitude, .3 * model_radius, 1e-16);
}

TEST(LoadPath, ForceAndRatioAreTheSameThing) {
    Case c = rolling_case();
    c.load.tangential_ratio.reset();
    c.load.tangential_force = 6;
    EXPECT_DOUBLE_EQ(path_of(c).loading[0].tangential[0].value, 6);
}

TEST(LoadPath, SuperposedOscillations) {
    Case c = rolling_case();
    c.rolling->steps_per_quarter = 5;
    c.load.tangential_ratio = .3;
    c.load.normal_amplitude_ratio = .4;
    c.load.normal_phase = pi / 2;  // at its peak when the roller is upright
    c.load.tangential_amplitude_ratio = .5;
    const LoadPath path = path_of(c);
    EXPECT_DOUBLE_EQ(path.loading[0].normal.value, 20 * 1.4);
    EXPECT_DOUBLE_EQ(path.loading[0].tangential[0].value, 3);
    for (const auto& step : path.period) {
        const double phase = step.phase;
        EXPECT_NEAR(step.normal.value, 20 * (1 + .4 * contact::triangle_wave(phase + .25)), 1e-13);
        EXPECT_NEAR(step.tangential[0].value, 3 * (1 + .5 * contact::triangle_wave(phase)), 1e-14);
    }
    EXPECT_DOUBLE_EQ(contact::press_step(c).normal.value, 20);  // ratios refer to the mean
}

TEST(LoadPath, IndentationMayOscillateToo) {
    Case c = rolling_case();
    c.load.normal_force.reset();
    c.load.indentation = 4e-4;
    c.load.normal_amplitude_ratio = .25;
    c.rolling->steps = Case::Steps::turning_points;
    const LoadPath path = path_of(c);
    EXPECT_EQ(path.period[0].normal.kind, contact::NormalControl::Kind::indentation);
    EXPECT_DOUBLE_EQ(path.period[0].normal.value, 5e-4);
    EXPECT_DOUBLE_EQ(path.period[2].normal.value, 3e-4);
    // the ratio refers to the force of the pressed model
    EXPECT_DOUBLE_EQ(path.period[2].tangential[0].value, 6);
}

std::string message_of(const Case& c) {
    try {
        path_of(c);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(LoadPath, FrictionLimitHoldsAllAlongThePath) {
    Case c = rolling_case();
    c.load.tangential_ratio = 1;
    EXPECT_EQ(
        message_of(c),
        "load: the tangential force 10 N reaches the friction limit mu F_N = 10 N at phase 0; "
        "lower tangential_force, tangential_ratio or limit_fraction (or their amplitude)");
    c.load.tangential_ratio = -1.5;  // either direction
    EXPECT_NE(message_of(c).find("the tangential force 15 N reaches"), std::string::npos);
    c.load.tangential_ratio = .999;
    EXPECT_EQ(message_of(c), "no error");
    c.rolling->steps = Case::Steps::turning_points;
    c.load.tangential_ratio = .9;
    c.load.normal_amplitude_ratio = .2;  // the force is least at phase 3/4
    EXPECT_EQ(
        message_of(c),
        "load: the tangential force 9 N reaches the friction limit mu F_N = 8 N at phase "
        "0.75; lower tangential_force, tangential_ratio or limit_fraction (or their amplitude)");
}

}  // namespace
}  // namespace tricontact::load_path_test
