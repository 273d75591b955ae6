#include "comparisons/shakedown/study_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "comparisons/shakedown/fit_document.h"
#include "tests/unit/comparisons/shakedown/rolling_study.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons::study_fit_test {
namespace {

/// Ratcheting as Du = c u_stat^(1/2) (w - w_lim) beyond the exact limit.
std::vector<RollingRun> ratcheting_runs(double c) {
    std::vector<RollingRun> runs;
    for (const double w : amplitudes)
        for (const double f : loads) {
            const double u_stat = theory::static_shift_ratio(f);
            const double excess = w - theory::amplitude_limit(f);
            RollingRun run = rolling_run(
                "mdr", w, f, excess > 0 ? contact::State::ratcheting : contact::State::shakedown);
            run.steps_per_quarter = 6;
            run.results.set(quantities::static_shift_ratio, u_stat);
            if (excess > 0)
                run.results.set(quantities::shift_increment_ratio, c * std::sqrt(u_stat) * excess);
            runs.push_back(run);
        }
    return runs;
}

TEST(MappingFit, ClosedFormGivesItsKappaBack) {
    for (const double kappa : {1., 1.1, 1.5}) {
        const auto groups = mapping_fits(settled_points(kappa), 0.95);
        ASSERT_EQ(groups.size(), 1u);
        ASSERT_TRUE(groups[0].constant);
        EXPECT_NEAR(groups[0].constant->fit.parameters[0].value, kappa, 1e-12);
        EXPECT_NEAR(groups[0].constant->of_left_side.r_squared, 1, 1e-12);
        // Two columns of the plane have nothing to explain.
        ASSERT_TRUE(groups[0].plane);
        EXPECT_NEAR(groups[0].plane->fit.parameters[0].value, kappa, 1e-10);
        EXPECT_NEAR(groups[0].plane->fit.parameters[1].value, 0, 1e-10);
        EXPECT_EQ(groups[0].uses.front().name, "fitted");
        EXPECT_NEAR(groups[0].uses.front().worst, 0, 1e-7);  // steep near the limit
    }
}

TEST(MappingFit, ThesisConstantBelongsToItsDirection) {
    auto points = settled_points(1.1);
    for (RollingPoint& p : points) p.angle = 2 * std::atan(1.);
    const auto uses = mapping_fits(points, 0.95).at(0).uses;
    ASSERT_EQ(uses.size(), 3u);
    EXPECT_EQ(uses[1].name, "thesis");
    EXPECT_NEAR(uses[1].worst, 0, 1e-12);
    EXPECT_GT(uses[2].worst, 0.1);  // MDR's kappa: larger shifts
}

TEST(MappingFit, NumericalErrorOfTheShiftBecomesThatOfKappa) {
    auto points = settled_points(1.);
    for (RollingPoint& p : points) p.values[&quantities::settled_shift_ratio].error = 1e-6;
    const auto groups = mapping_fits(points, 0.95);
    for (const MappingPoint& p : groups.at(0).points) {
        const double w = p.at.amplitude_ratio, f = p.at.tangential_ratio;
        const double u = p.at.at(quantities::settled_shift_ratio).value;
        const double change =
            theory::mapping_parameter(w, f, u + 1e-6) - theory::mapping_parameter(w, f, u - 1e-6);
        // First order: what a central difference leaves is of order (1e-6/u)^2.
        EXPECT_NEAR(p.kappa.error, std::abs(change) / 2, 1e-8 + 1e-5 * std::abs(change));
    }
}

TEST(MappingFit, IntervalsCoverTheTruthAsOftenAsTheyClaim) {
    const auto points = settled_points(1.2);
    std::mt19937 generator(5);
    std::normal_distribution<double> noise(0, 1e-3);
    int n_covered = 0;
    const int n = 2000;
    for (int k = 0; k < n; ++k) {
        auto noisy = points;
        // f_T is what the regression takes for observed.
        for (RollingPoint& p : noisy) p.tangential_ratio += noise(generator);
        const statistics::Estimate e = mapping_fits(noisy, 0.9).at(0).constant->fit.parameters[0];
        n_covered += e.low <= 1.2 && 1.2 <= e.high;
    }
    // Binomial: four standard deviations of 2000 trials at 0.9 are 0.027.
    EXPECT_NEAR(n_covered / static_cast<double>(n), 0.9, 0.027);
}

// Of observed values that are all one nothing is explained: R^2 is 0/0, not what rounding makes of
// it.
TEST(Goodness, OfWhatDoesNotVaryIsUndefined) {
    const std::vector<double> observed(6, .6);
    EXPECT_TRUE(std::isnan(goodness(observed, {.61, .59, .6, .62, .58, .6}).r_squared));
    // Rounding of such values as a study has them.
    EXPECT_TRUE(std::isnan(goodness({.6, .6 + 1e-16, .6, .6}, {.61, .59, .61, .59}).r_squared));
    EXPECT_NEAR(goodness({1, 2, 3}, {1, 2, 3}).r_squared, 1, 1e-15);
}

TEST(MappingFit, WithTooFewPointsNothingIsFitted) {
    auto points = settled_points(1.);
    points.resize(2);
    const auto groups = mapping_fits(points, 0.95);
    EXPECT_FALSE(groups.at(0).constant);
    EXPECT_FALSE(groups.at(0).plane);
    EXPECT_EQ(groups.at(0).points.size(), 2u);
    EXPECT_TRUE(mapping_fits({}, 0.95).empty());
}

TEST(MappingFit, UndecidedPointsAreLeftOut) {
    RollingRun moving = rolling_run("mdr", 0.5, 0.25, contact::State::undecided);
    moving.results.set(quantities::shift_increment_ratio, 1e-4);
    EXPECT_TRUE(mapping_fits(rolling_points({moving}), 0.95).at(0).points.empty());
}

TEST(LimitCurve, FindsTheNumberOfItsForm) {
    for (const double k : {1., 1.2, 1.5}) {
        std::vector<LimitPoint> limits;
        for (const double w : amplitudes)
            limits.push_back({w, {1 - k * w * (1 - w * w) - w * w * w, 0}});
        EXPECT_NEAR(fit_limit(limits, 0.95)->fit.parameters[0].value, k, 1e-12);
    }
}

TEST(RatchetingFit, FindsTheCoefficientOfItsForm) {
    const auto groups = ratcheting_fits(rolling_points(ratcheting_runs(4.77)), 0.95);
    ASSERT_EQ(groups.size(), 1u);
    ASSERT_TRUE(groups[0].root);
    EXPECT_NEAR(groups[0].root->fit.parameters[0].value, 4.77, 1e-9);
    ASSERT_TRUE(groups[0].root_of_eta);
    EXPECT_NEAR(groups[0].root_of_eta->fit.parameters[0].value, 4.77, 1e-9);
    EXPECT_NEAR(groups[0].limit->fit.parameters[0].value, 1.5, 1e-12);
    for (const RatchetingPoint& p : groups[0].points)
        EXPECT_NEAR(p.eta.value, 4.77 * std::sqrt(p.at.at(quantities::static_shift_ratio).value),
                    1e-8);
}

TEST(RatchetingFit, OneAmplitudePerLoadGivesNoSlope) {
    std::vector<RollingRun> runs;
    for (const RollingRun& run : ratcheting_runs(2.))
        if (run.results.number(quantities::amplitude_ratio) == 0.74) runs.push_back(run);
    const auto group = ratcheting_fits(rolling_points(runs), 0.95).at(0);
    EXPECT_FALSE(group.points.empty());
    for (const RatchetingLoad& load : group.loads) EXPECT_FALSE(load.slope);
    EXPECT_FALSE(group.root_of_eta);
    EXPECT_FALSE(group.points.front().eta.has_bar());
}

TEST(StudyFit, ModelsAndGroupsStayApart) {
    StudyFit fit;
    fit.points = settled_points(1.5);
    for (RollingPoint& p : settled_points(1., "bem")) fit.points.push_back(p);
    for (RollingPoint& p : settled_points(1.1, "bem")) {
        p.group = "perpendicular";
        fit.points.push_back(p);
    }
    evaluate(fit);
    const auto json = nlohmann::json::parse(fit_json(fit));
    ASSERT_EQ(json["kappa"].size(), 3u);
    const double expected[] = {1.5, 1, 1.1};
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(json["kappa"][i]["constant"]["parameters"]["kappa"]["value"].get<double>(),
                    expected[i], 1e-12);
    // A row of names and one per parameter: kappa, the plane's three, k of the limit.
    const std::string csv = fits_csv(fit);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 5);
}

TEST(StudyFit, TableOfPointsHasEachResultWithItsError) {
    StudyFit fit;
    fit.points = {{.model = "bem",
                   .group = "parallel, at 8 mm",
                   .amplitude_ratio = .25,
                   .tangential_ratio = .5,
                   .state = contact::State::shakedown,
                   .values = {{&quantities::static_shift_ratio, {.375, .125}},
                              {&quantities::settled_shift_ratio, Computed{.5}},
                              {&quantities::limit_tangential_ratio, {.75, .0625}}}}};
    std::istringstream text(points_csv(fit));
    std::string names, values;
    std::getline(text, names);
    std::getline(text, values);
    EXPECT_TRUE(
        names.starts_with("model,group,amplitude_ratio,tangential_ratio,state,"
                          "static_shift_m,static_shift_m_error,static_shift_ratio,"))
        << names;
    EXPECT_TRUE(names.ends_with(",stick_ratio,stick_ratio_error,caveat")) << names;
    EXPECT_EQ(
        values,
        "bem,\"parallel, at 8 mm\",0.25,0.5,shakedown,,,0.375,0.125,,,0.5,,,,,,0.75,0.0625,,,,,");
}

// The thesis' 1 - w is above every model's limit; made up ones may be higher.
TEST(FitSentences, TheThesisLimitLiesWhereItLies) {
    const auto words = [](double factor) {
        StudyFit fit;
        fit.points = settled_points(1.5);
        for (RollingPoint& p : fit.points)
            p.values[&quantities::limit_tangential_ratio].value = factor * (1 - p.amplitude_ratio);
        evaluate(fit);
        std::string text;
        for (const report::Verdict& verdict : fit_verdicts(fit)) text += verdict.sentence + '\n';
        return text;
    };
    EXPECT_NE(words(0.8).find("lies 25 % above the model's"), std::string::npos) << words(0.8);
    EXPECT_NE(words(1.25).find("lies 20 % below the model's"), std::string::npos) << words(1.25);
    EXPECT_EQ(words(1.25).find("above the model's"), std::string::npos) << words(1.25);
}

}  // namespace
}  // namespace tricontact::comparisons::study_fit_test
