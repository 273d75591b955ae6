// What figures and tables show of a run made by hand, in a machine whose scales all differ.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "walking/machine/linear_stability.h"
#include "walking/machine/motion.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking::walk_figures_test {
namespace {

/// mu kappa4 = 4e-5, z_stat = kappa4/(2 kappa2) = 2.5e-5, mu kappa3 kappa4 = 2e-5.
Machine machine() {
    return {.kappas = {2, 2, 0.5, 1e-4, 0.4, 2e-4, 0.42, 1.18}};
}
constexpr double rest = 2.5e-5, load = 4e-5;

/// `n` states of the end of a run, 0.1 apart, both spots slipping.
template <class MotionAt>
WalkReport ending(int n, MotionAt motion_at) {
    WalkReport report;
    report.walk_case.machine = machine();
    for (int i = 0; i < n; ++i) {
        Motion motion = motion_at(0.1 * i);
        motion.time = 30 + 0.1 * i;
        motion.spots.resize(2);
        report.walk.tail.push_back({motion, {SpotState::slip, SpotState::slip}});
    }
    return report;
}

/// The body at rest under a spring whose force swings about that of steady sliding.
WalkReport vibrating(double amplitude, double frequency) {
    return ending(1601, [=](double t) {
        const double swing = amplitude * std::sin(2 * std::numbers::pi * frequency * t);
        return Motion{.base = load * (1 + swing) / 2};
    });
}

report::Figure figure(const report::DocumentSection& section, const std::string& id) {
    for (const report::Figure& each : section.figures)
        if (each.id == id) return each;
    throw std::invalid_argument("no figure " + id);
}

std::vector<report::Cell> row(const report::DocumentTable& table, const std::string& name) {
    for (const auto& each : table.rows)
        if (std::get<std::string>(each[0]) == name) return each;
    throw std::invalid_argument("no row " + name);
}

TEST(WalkFigures, MotionIsOverItsOwnUnits) {
    const WalkReport report = ending(2, [](double) {
        return Motion{.base = 3e-3, .x = 3e-3 + 8e-5, .z = 5e-5, .phi = 4e-6, .x_velocity = 5e-4};
    });
    const MotionCurves curves = motion_curves(machine(), report.walk.tail);
    EXPECT_NEAR(curves.z.x[1], 0.1, 1e-12);
    EXPECT_NEAR(curves.displacement.y[0], 2, 1e-12);
    EXPECT_NEAR(curves.z.y[0], 2, 1e-12);
    EXPECT_NEAR(curves.phi.y[0], 0.2, 1e-12);
    EXPECT_NEAR(curves.force.y[0], 2 * (-8e-5 + 1.18 * 4e-6) / load, 1e-12);
    const report::Curve orbit = figure(motion_section(report), "phase_plane").curves.back();
    EXPECT_NEAR(orbit.x[0], 2, 1e-12);
    EXPECT_NEAR(orbit.y[0], 2.5, 1e-12);  // 5e-4 over kappa6
}

// Three periods of 4 are the first that take at least 10; without a period it is 20.
TEST(WalkFigures, ShowWholePeriodsFromEndToEnd) {
    WalkReport report = ending(301, [](double) { return Motion{}; });
    const auto length = [&] {
        const auto shown = last_swings(report.walk);
        return shown.back().motion.time - shown.front().motion.time;
    };
    EXPECT_NEAR(length(), 20, 1e-9);
    report.walk.result.period = 4;
    EXPECT_NEAR(length(), 12, 1e-9);
}

TEST(WalkFigures, PhasesAreSharesOfThePeriod) {
    WalkReport report = ending(301, [](double) { return Motion{}; });
    report.walk.phases = WalkPhases{.period = 4,
                                    .sticking = 50,
                                    .turning_point = 51,
                                    .release = 52.4,
                                    .jump = 52.8,
                                    .landing = 53.5};
    const report::DocumentTable table = motion_section(report).tables.front();
    constexpr double begins[] = {0, 0.25, 0.6, 0.7, 0.875};
    ASSERT_EQ(table.rows.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(std::get<double>(table.rows[i][1]), begins[i], 1e-12) << i;
}

// While a spot slides its friction is at its bound, of both contacts of a side in the prism.
TEST(WalkFigures, FrictionOfASlidingSpotLiesOnItsBound) {
    for (const auto model : {Machine::Model::two_spot, Machine::Model::prism}) {
        WalkReport report = ending(2, [](double) { return Motion{}; });
        Machine& sliding = report.walk_case.machine;
        sliding.model = model;
        for (auto& snapshot : report.walk.tail) {
            const double time = snapshot.motion.time;
            snapshot.motion = *steady_sliding(sliding);
            snapshot.motion.time = time;
        }
        const report::Figure forces = figure(contact_section(report), "spot_2");
        EXPECT_GT(forces.curves[1].y[0], 0);
        EXPECT_NEAR(forces.curves[1].y[0], forces.curves[2].y[0], 1e-12);
        EXPECT_NEAR(forces.curves[1].y[0], -forces.curves[3].y[0], 1e-12);
    }
}

/// 40 windows of 10; the first half is transient, in which the spots stick otherwise.
WalkReport windows(double stick_in_transient) {
    WalkReport report = ending(2, [](double) { return Motion{}; });
    for (int i = 0; i < 40; ++i) {
        const bool transient = i < 20;
        SpotSums spot;
        spot.sticking = static_cast<std::int64_t>(
            1000 * (transient ? stick_in_transient * (i % 2) : 0.4 + 0.01 * (i * 7 % 10)));
        report.walk.windows.push_back({.begin = 10. * i,
                                       .end = 10. * (i + 1),
                                       .sums = {.steps = 1000, .spots = {spot, spot}}});
        auto& sums = report.walk.windows.back().sums;
        sums.spring_force = 1000 * load * (transient ? 0.9 : 0.5);
        sums.z_min = -3 * rest, sums.z_max = 2 * rest;
    }
    report.walk.result = {.regime = Regime::chaotic,
                          .z_min_ratio = -3,
                          .z_max_ratio = 2,
                          .spots = {{0.445, -0.7}, {0.445, -0.7}},
                          .transient = 200,
                          .transient_over = true,
                          .observed = 200};
    return report;
}

TEST(WalkFigures, ErrorsOfSpotsDoNotDependOnTheTransient) {
    const double error = spot_statistics(windows(0).walk).front().stick_time.error;
    EXPECT_GT(error, 0);
    EXPECT_EQ(error, spot_statistics(windows(1).walk).front().stick_time.error);
}

TEST(WalkFigures, CourseIsThatOfTheWindows) {
    const report::DocumentSection section = course_section(windows(0));
    const report::Curve force = figure(section, "force_means").curves[0];
    EXPECT_EQ(force.x[3], 35);  // middle of the fourth
    EXPECT_NEAR(force.y[19], 0.9, 1e-12);
    EXPECT_NEAR(force.y[20], 0.5, 1e-12);
    const report::Figure heights = figure(section, "heights");
    EXPECT_EQ(heights.curves[0].name, "highest");  // z counts downwards
    EXPECT_NEAR(heights.curves[0].y[3], -3, 1e-12);
    EXPECT_NEAR(heights.curves[1].y[3], 2, 1e-12);
}

TEST(WalkFigures, ReturnMapHasEachReturnOverTheOneBefore) {
    WalkReport report = windows(0);
    for (const double z : {1., 3., 4.}) report.walk.returns.push_back({{.z = z * rest}, {}});
    const report::DocumentSection section = course_section(report);
    const report::Curve points = figure(section, "returns").curves[0];
    ASSERT_EQ(points.x.size(), 2u);
    EXPECT_NEAR(points.x[1], 3, 1e-12);
    EXPECT_NEAR(points.y[1], 4, 1e-12);
}

TEST(WalkFigures, EnergyIsInItsOwnRows) {
    const EnergyStretch stretch{
        {.base = 8, .excitation = 0.5, .geometric = -1, .dissipation = 5, .stored = 2}, 4, 8};
    const report::DocumentTable table = energy_section(stretch).tables.front();
    const auto value = [&](const std::string& name) {
        return std::get<double>(row(table, name)[1]);
    };
    EXPECT_EQ(value("work of the base"), 8);
    EXPECT_EQ(value("work of the excitation"), 0.5);
    EXPECT_EQ(value("geometric work"), -1);
    EXPECT_EQ(value("dissipation"), 5);
    EXPECT_EQ(value("change of stored energy"), 2);
    EXPECT_EQ(value("lost by the integration"), 8 + 0.5 - 1 - 5 - 2);
    EXPECT_EQ(std::get<double>(row(table, "dissipation")[2]), 5. / 8);
}

// A block under a friction of F = mu kappa4 = 0.01, dragged by 0.02 in 100 units of time: half of
// the way loads the springs, which store F^2/2 (1/kappa1 + 1/2) = F^2/2, over the other half it
// slides. The work of the base is the sum of both. The stretch swings by kappa6/sqrt(kappa1), a
// work of 1.4e-6.
TEST(WalkFigures, EnergyOfABlockIsThatOfItsSpringAndItsFriction) {
    WalkReport report;
    Machine& block = report.walk_case.machine;
    block = machine();
    block.mechanisms = {.vertical = false, .rotation = false};
    block.kappas.kappa5 = 100;
    report.walk.last = motion_at_start(block);
    const auto energy = energy_of(report);
    ASSERT_TRUE(energy);
    EXPECT_NEAR(energy->length, 100, 1e-9);
    EXPECT_NEAR(energy->balance.stored, 0.5e-4, 1.5e-6);
    EXPECT_NEAR(energy->balance.dissipation, 1e-4, 1.5e-6);
    EXPECT_NEAR(energy->balance.base, 1.5e-4, 1.5e-6);
    EXPECT_EQ(energy->scale, energy->balance.base);
}

// The variance of a sine of amplitude a in ten of its periods is a^2/2, wherever they begin: above
// the threshold of 0.1 at a = 0.5, below at 0.4.
TEST(WalkFigures, RunningVarianceIsThatOfTenPeriods) {
    for (const double amplitude : {0.4, 0.5}) {
        const WalkReport report = vibrating(amplitude, 0.5);
        const auto vibration = vibration_of(machine(), report.walk);
        ASSERT_TRUE(vibration);
        EXPECT_NEAR(vibration->window, 20, 1e-6);
        ASSERT_EQ(vibration->variances.size(), 1601u - 200 + 1);
        for (const double variance : vibration->variances)
            ASSERT_NEAR(variance, amplitude * amplitude / 2, 1e-12);
        EXPECT_EQ(vibration->instability, amplitude > 0.45);
        // Each in the middle of its window: half a window from both ends, but for a stride.
        const report::DocumentSection section = vibration_section(report, *vibration);
        const report::Curve curve = figure(section, "variance").curves[0];
        EXPECT_NEAR(curve.x.front(), 10, 1e-6);
        EXPECT_NEAR(curve.x.back(), 160 - 10, 0.2);
    }
}

// Relative errors of a frequency and of its period are the same.
TEST(WalkFigures, FrequencyOfTheCycleHasTheErrorOfItsPeriod) {
    WalkReport report = vibrating(0.4, 0.5);
    report.walk.result.period = 4;
    report.walk.result.period_error = 0.1;
    const auto vibration = vibration_of(machine(), report.walk);
    ASSERT_TRUE(vibration);
    const report::DocumentSection section = vibration_section(report, *vibration);
    const auto cycle =
        std::get<report::WithError>(row(section.tables.front(), "of the limit cycle")[1]);
    EXPECT_EQ(cycle.value, 0.25);
    EXPECT_NEAR(cycle.error / cycle.value, 0.1 / 4, 1e-15);
}

// exp(0.1 t) is ten at t = ln(10)/0.1 = 23.03.
TEST(WalkFigures, NearbyMotionsPartTenfoldAtTheirExponent) {
    WalkReport report = windows(0);
    report.walk.result.lyapunov = statistics::Mean{0.1, 0.01};
    std::string text;
    for (const report::Verdict& verdict : walk_verdicts(report, {}))
        text += verdict.sentence + '\n';
    EXPECT_NE(text.find("nearby trajectories diverge tenfold in 23, chaos"), std::string::npos)
        << text;
}

// Half of 400 independent places are unstable: 50 % with the error of a binomial, 4.9 %. One series
// tells its correlation, and with it the error, to some 20 %.
TEST(WalkFigures, InstabilityHasItsErrorInPercent) {
    WalkReport report = windows(0);
    Vibration vibration;
    vibration.characteristic = {0.25, 0.01};
    vibration.instability = 0.5;
    unsigned state = 1;
    for (int i = 0; i < 400; ++i) {
        state = 1664525 * state + 1013904223;  // Numerical Recipes (1992), section 7.1
        vibration.variances.push_back(state >> 31 ? 0.2 : 0);
    }
    const std::string text = walk_verdicts(report, vibration).back().sentence;
    const auto at = text.find("Unstable, variance above 0.1: ");
    ASSERT_NE(at, std::string::npos) << text;
    const auto sign = text.find("± ", at);
    EXPECT_NEAR(std::stod(text.substr(sign + std::string("± ").size())), 4.9, 1) << text;
}

}  // namespace
}  // namespace tricontact::walking::walk_figures_test
