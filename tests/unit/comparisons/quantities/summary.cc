#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/results.h"
#include "comparisons/quantities/undefined.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::summary_test {
namespace {

using contact::State;
using synthetic::Options;

// All expected numbers are exact in the synthetic histories; only rounding remains.
constexpr double rounding = 1e-13;

TEST(Summary, RatiosAreOverTheModelsOwnUnits) {
    const Options options{.f = 0.488, .w = 0.2, .periods = 3};  // 1 - f = 0.8^3: u_stat = 0.36
    contact::History history = synthetic::settling_history("mdr", options);
    history.scales.contact_radius = 0.5;
    history.scales.unit_shift = 4;
    const Results s(synthetic::unit_case(options), history);
    EXPECT_DOUBLE_EQ(s.number(quantities::static_shift).value(), 0.36);
    EXPECT_DOUBLE_EQ(s.number(quantities::static_shift_ratio).value(), 0.09);
    EXPECT_DOUBLE_EQ(s.number(quantities::amplitude_ratio).value(), 0.4);
    EXPECT_DOUBLE_EQ(s.number(quantities::tangential_ratio).value(), 0.488);
    EXPECT_DOUBLE_EQ(s.number(quantities::final_shift).value(), history.shift_per_period.back());
    EXPECT_DOUBLE_EQ(s.number(quantities::final_shift_ratio).value(),
                     history.shift_per_period.back() / 4);
    ASSERT_EQ(s.list(quantities::shift_ratio_per_period).size(), 3u);
    EXPECT_DOUBLE_EQ(s.number(quantities::shift_increment_ratio).value(),
                     *s.list(quantities::shift_ratio_per_period)[2] -
                         *s.list(quantities::shift_ratio_per_period)[1]);
}

TEST(Summary, FirstPeriodsIncrementCountsFromTheStaticShift) {
    const Options options{.f = 0.488, .w = 0.2, .periods = 1};
    const Results s(synthetic::unit_case(options), synthetic::settling_history("mdr", options));
    EXPECT_NEAR(s.number(quantities::shift_increment_ratio).value(),
                s.number(quantities::final_shift_ratio).value() - 0.36, rounding);
}

TEST(Summary, KappaOfTheClosedFormIsThreeHalves) {
    for (const Options& o : {Options{.f = 0.56, .w = 0.24}, Options{.f = 0.2, .w = 0.5},
                             Options{.f = 0.9, .w = 0.02}}) {
        const Results s(synthetic::unit_case(o), synthetic::settling_history("mdr", o));
        // Rounding of f counts 1/(w u) <= 60 times.
        EXPECT_NEAR(s.number(quantities::kappa).value(), 1.5, 60 * rounding) << o.f;
        EXPECT_FALSE(s.number(quantities::eta));
    }
}

TEST(Summary, KappaIsEmptyWhereUndefined) {
    const Options base{.f = 0.3, .w = 0.2};
    const contact::Case c = synthetic::unit_case(base);
    contact::History undecided = synthetic::settling_history("mdr", base);
    undecided.verdict.state = State::undecided;
    // It may be open whether all of a settled contact sticks, but not where it stands.
    EXPECT_TRUE(Results(c, undecided).number(quantities::kappa));
    undecided.verdict.remaining_error = 0.01;
    EXPECT_FALSE(Results(c, undecided).number(quantities::kappa));
    EXPECT_FALSE(Results(c, synthetic::settling_history("mdr", {.f = 0.3, .w = 0}))
                     .number(quantities::kappa));
    EXPECT_FALSE(Results(c, synthetic::settling_history("mdr", {.f = 0, .w = 0.2}))
                     .number(quantities::kappa));
    contact::Case oscillating = c;
    oscillating.load.tangential_amplitude_ratio = 0.1;
    EXPECT_FALSE(
        Results(oscillating, synthetic::settling_history("mdr", base)).number(quantities::kappa));
    contact::History too_far = synthetic::settling_history("mdr", base);
    too_far.shift_per_period.back() = 1.2;  // (1 - u)^(3/2) is not real
    EXPECT_FALSE(Results(c, too_far).number(quantities::kappa));
}

/// With the surfaces that w_lim comes from.
contact::History ratcheting(const Options& options) {
    contact::History history = synthetic::ratcheting_history("bem", options, 0.6);
    synthetic::add_snapshots(history, options, false);
    return history;
}

TEST(Summary, EtaOverTheDistanceFromTheLimit) {
    // Of Hertz' pressures w_lim = 0.2: f = 1 - 0.3 + 0.004; Du = 0.6 at w = 0.5 makes eta =
    // 0.6/0.3. The distance errs by a few thousandths of a cell's 0.07 a: the edge is cut by square
    // cells.
    const Options options{.f = 0.704, .w = 0.5, .periods = 4};
    const Results s(synthetic::unit_case(options), ratcheting(options));
    EXPECT_NEAR(s.number(quantities::limit_amplitude_ratio).value(), .2, 2e-3);
    EXPECT_NEAR(s.number(quantities::eta).value(), 2, .02);
    EXPECT_FALSE(s.number(quantities::kappa));
}

TEST(Summary, EtaIsEmptyWhereUndefined) {
    const Options options{.f = 0.704, .w = 0.5, .periods = 4};
    const contact::Case c = synthetic::unit_case(options);
    contact::History undecided = ratcheting(options);
    undecided.verdict.state = State::undecided;
    EXPECT_FALSE(Results(c, undecided).number(quantities::eta));
    const Options below{.f = 0.704, .w = 0.19, .periods = 4};
    EXPECT_FALSE(Results(c, ratcheting(below)).number(quantities::eta));
    contact::Case oscillating = c;
    oscillating.load.normal_amplitude_ratio = .1;
    EXPECT_FALSE(Results(oscillating, ratcheting(options)).number(quantities::eta));
}

// What a step from one turning point to the next shifts depends on it: `fit` leaves it out, too.
TEST(Summary, EtaIsNotToldByTurningPoints) {
    const Options options{.f = 0.704, .w = 0.5, .periods = 4};
    contact::Case c = synthetic::unit_case(options);
    EXPECT_TRUE(Results(c, ratcheting(options)).number(quantities::eta));
    EXPECT_TRUE(why_undefined(c, Results(c, ratcheting(options))).empty());
    contact::Case coarse = c;
    coarse.rolling->steps = contact::Case::Steps::turning_points;
    contact::Case one_step = c;
    one_step.rolling->steps_per_quarter = 1;
    for (const contact::Case& by_turning_points : {coarse, one_step}) {
        const Results s(by_turning_points, ratcheting(options));
        EXPECT_FALSE(s.number(quantities::eta));
        EXPECT_TRUE(s.number(quantities::shift_increment));
        const auto why = why_undefined(by_turning_points, s);
        ASSERT_EQ(why.size(), 1u);
        EXPECT_EQ(why.front().first, &quantities::eta);
        EXPECT_NE(why.front().second.find("set rolling.steps_per_quarter"), std::string::npos);
    }
}

TEST(Summary, SaysWhyKappaIsUndefined) {
    const Options base{.f = 0.3, .w = 0.2};
    const auto why = [&](const contact::Case& c, const Options& options) {
        const auto all = why_undefined(c, Results(c, synthetic::settling_history("mdr", options)));
        return all.empty() ? std::string() : all.front().second;
    };
    const contact::Case c = synthetic::unit_case(base);
    EXPECT_EQ(why(c, base), "");
    contact::Case cone = c;
    cone.indenter.shape = contact::Case::Shape::cone;
    cone.indenter.angle = .1;
    EXPECT_NE(why(cone, base).find("paraboloid or sphere"), std::string::npos) << why(cone, base);
    // Nor is there a peak of its pressure, whatever the cell under the tip has.
    const Results pressed(cone, synthetic::settling_history("bem", base));
    EXPECT_FALSE(pressed.number(quantities::peak_pressure));
    EXPECT_TRUE(
        Results(c, synthetic::settling_history("bem", base)).number(quantities::peak_pressure));
    EXPECT_EQ(why_undefined(cone, pressed).back().first, &quantities::peak_pressure);
    contact::Case oscillating = c;
    oscillating.load.tangential_amplitude_ratio = .1;
    EXPECT_EQ(why(oscillating, base), "the loads oscillate");
    const Options at_rest{.f = 0.3, .w = 0};
    EXPECT_NE(why(synthetic::unit_case(at_rest), at_rest).find("below 1e-5"), std::string::npos);
}

TEST(Summary, DissipationOverMindlinsCycle) {
    // An integration of the spring bed gives W0 = 0.0729909 at f = 0.6 in these units.
    const Options options{.f = 0.6, .w = 0.1, .periods = 2};
    contact::History history = synthetic::settling_history("mdr", options);
    history.dissipation_per_period = {0.0729909, 0.00729909};
    const Results s(synthetic::unit_case(options), history);
    ASSERT_EQ(s.list(quantities::dissipation_ratio_per_period).size(), 2u);
    // Six digits are given of W0.
    EXPECT_NEAR(s.list(quantities::dissipation_ratio_per_period)[0].value(), 1, 1e-6);
    EXPECT_NEAR(s.list(quantities::dissipation_ratio_per_period)[1].value(), 0.1, 1e-7);
}

TEST(Summary, DissipationWithoutTangentialForceHasNoUnit) {
    const Options options{.f = 0, .w = 0.1, .periods = 2};
    const Results s(synthetic::unit_case(options), synthetic::settling_history("mdr", options));
    ASSERT_EQ(s.list(quantities::dissipation_ratio_per_period).size(), 2u);
    EXPECT_FALSE(s.list(quantities::dissipation_ratio_per_period)[0]);
}

TEST(Summary, WithoutRollingThereIsNoVerdict) {
    const Options options{.f = 0.488, .rolling = false};
    const Results s(synthetic::unit_case(options), synthetic::loaded_history("bem", options));
    EXPECT_FALSE(s.state());
    EXPECT_FALSE(s.number(quantities::shift_increment_ratio));
    EXPECT_EQ(s.periods(), 0);
    EXPECT_DOUBLE_EQ(s.number(quantities::final_shift_ratio).value(), 0.36);
}

TEST(Summary, WorstForceResidualOfAllSteps) {
    contact::History history = synthetic::settling_history("bem");
    history.steps[17].force_residual = 3e-9;
    EXPECT_DOUBLE_EQ(*Results(synthetic::unit_case(), history)
                          .number(synthetic::quantity_of("max_force_residual_ratio")),
                     3e-9);
}

TEST(SummaryJson, ReadsBackBitForBitWithFixedKeys) {
    const Results s(synthetic::unit_case(), synthetic::settling_history("mdr"));
    const auto json = nlohmann::ordered_json::parse(
        summary_json("1.2.3", {{"title", "x <&> \"y\""}, {"load", {{"f", 0.1}}}}, {s}));
    EXPECT_EQ(json["version"], "1.2.3");
    EXPECT_EQ(json["case"]["title"], "x <&> \"y\"");
    const auto& m = json["models"]["mdr"];
    // What users have read since the first version.
    const std::vector<std::string> published{"contact_radius_m",
                                             "indentation_m",
                                             "peak_pressure_Pa",
                                             "unit_shift_m",
                                             "static_shift_ratio",
                                             "shift_ratio_per_period",
                                             "final_shift_ratio",
                                             "shift_increment_ratio",
                                             "static_shift_m",
                                             "final_shift_m",
                                             "state",
                                             "periods",
                                             "limit_tangential_ratio",
                                             "stick_ratio",
                                             "kappa",
                                             "eta",
                                             "dissipation_ratio_per_period",
                                             "ends",
                                             "subsurface",
                                             "steps",
                                             "cpu_s",
                                             "wall_s",
                                             "max_force_residual_ratio",
                                             "audit"};
    for (const std::string& key : published) EXPECT_TRUE(m.contains(key)) << key;
    EXPECT_EQ(m["peak_pressure_Pa"].get<double>(), s.number(quantities::peak_pressure).value());
    for (int n = 0; n < 12; ++n)
        EXPECT_EQ(m["shift_ratio_per_period"][n].get<double>(),
                  s.list(quantities::shift_ratio_per_period).at(n));
    EXPECT_EQ(m["kappa"].get<double>(), s.number(quantities::kappa).value());
    EXPECT_TRUE(m["eta"].is_null());
    EXPECT_EQ(m["state"], "shakedown");
    EXPECT_EQ(m["audit"]["friction_bound"]["worst"].get<double>(), 1e-13);
    EXPECT_EQ(m["audit"]["friction_bound"]["passed"], true);
}

TEST(SummaryJson, NonFiniteNumbersBecomeNull) {
    contact::History history = synthetic::settling_history("mdr");
    history.scales.unit_shift = 0;  // every shift ratio is infinite or not a number
    history.audit.record("broken", std::numeric_limits<double>::quiet_NaN(), 1e-10);
    const std::string text = summary_json("1", nullptr, {Results(synthetic::unit_case(), history)});
    const auto json = nlohmann::ordered_json::parse(text);  // "nan" or "inf" would not parse
    EXPECT_TRUE(json["models"]["mdr"]["final_shift_ratio"].is_null());
    EXPECT_TRUE(json["models"]["mdr"]["shift_ratio_per_period"][0].is_null());
    EXPECT_TRUE(json["models"]["mdr"]["audit"]["broken"]["worst"].is_null());
    EXPECT_EQ(json["models"]["mdr"]["audit"]["broken"]["passed"], false);
}

TEST(Reference, ClosedFormsOfTheCase) {
    const Reference r = reference(synthetic::unit_case({.f = 0.488, .w = 0.2}));
    EXPECT_NEAR(r.static_shift_ratio, 0.36, rounding);
    EXPECT_NEAR(r.limit_tangential_ratio.value(), 1 - 0.3 + 0.004, rounding);
    // The settled shift solves f = 1 - 1.5 w u - (1 - u)^1.5.
    const double u = r.shakedown_shift_ratio.value();
    EXPECT_NEAR(1 - 0.3 * u - std::pow(1 - u, 1.5), 0.488, rounding);
}

TEST(Reference, NothingIsClaimedOutsideItsAssumptions) {
    contact::Case c = synthetic::unit_case({.f = 0.9, .w = 0.5});
    EXPECT_FALSE(reference(c).shakedown_shift_ratio);  // ratchets
    EXPECT_TRUE(reference(c).limit_tangential_ratio);
    c.load.normal_amplitude_ratio = 0.1;
    EXPECT_FALSE(reference(c).limit_tangential_ratio);
    EXPECT_FALSE(reference(synthetic::unit_case({.f = 0.9, .w = 1.2})).limit_tangential_ratio);
    EXPECT_FALSE(reference(synthetic::unit_case({.rolling = false})).limit_tangential_ratio);
}

}  // namespace
}  // namespace tricontact::comparisons::summary_test
