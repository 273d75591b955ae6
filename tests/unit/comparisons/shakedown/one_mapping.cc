#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "comparisons/shakedown/study_fit.h"
#include "tests/unit/comparisons/shakedown/rolling_study.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons::one_mapping_test {
namespace {

OneMapping one_of(const std::vector<RollingPoint>& points) {
    return mapping_fits(points, 0.95).at(0).one;
}

using Finding = report::Verdict::Standing;

// kappa from .45 at w = .1 to 1.14 at w = .74: without numerical errors nobody can say that the
// points differ, and one kappa does not hold either; with small errors it fails.
TEST(OneMapping, NeverHoldsForWantOfErrors) {
    auto points = settled_points(1.);
    for (RollingPoint& p : points) {
        const double kappa = 0.45 + (p.amplitude_ratio - 0.1) / 0.64 * 0.69;
        p.values[&quantities::settled_shift_ratio] =
            Computed{*theory::settled_shift_ratio(p.amplitude_ratio, p.tangential_ratio, kappa)};
    }
    EXPECT_EQ(one_of(points).finding, Finding::not_testable);
    EXPECT_EQ(one_of(points).n_with_bars, 0);
    for (RollingPoint& p : points)
        p.values[&quantities::settled_shift_ratio].error =
            1e-3 * p.values[&quantities::settled_shift_ratio].value;
    EXPECT_EQ(one_of(points).finding, Finding::violated);
    EXPECT_GT(one_of(points).low, one_of(points).high);
    // Errors so large that everything goes through tell nothing.
    for (RollingPoint& p : points)
        p.values[&quantities::settled_shift_ratio].error =
            0.5 * p.values[&quantities::settled_shift_ratio].value;
    EXPECT_EQ(one_of(points).finding, Finding::not_testable);
    StudyFit fit;
    fit.points = points;
    evaluate(fit);
    const auto verdicts = fit_document(fit).verdicts;
    for (const report::Verdict& verdict : verdicts)
        for (const auto good : {report::Verdict::Standing::holds, report::Verdict::Standing::pass})
            EXPECT_NE(verdict.standing, good) << verdict.sentence;
}

// Shifts of kappa = 1.1 moved by a part of their errors: a kappa within all of them exists, and the
// interval of those that do holds 1.1. Moved by more than their errors: it does not hold.
TEST(OneMapping, IsWhatServesAllPointsWithinTheirErrors) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> even(-1, 1);
    for (const double part : {0.9, 5.}) {
        auto points = settled_points(1.1);
        for (RollingPoint& p : points) {
            Computed& u = p.values[&quantities::settled_shift_ratio];
            u.error = 3e-3 * u.value;
            u.value += part * u.error * even(generator);
        }
        const OneMapping one = one_of(points);
        EXPECT_EQ(one.finding, part < 1 ? Finding::holds : Finding::violated);
        EXPECT_EQ(one.low <= 1.1 && 1.1 <= one.high, part < 1);
        EXPECT_FALSE(one.is_negligible);
    }
    EXPECT_TRUE(one_of(settled_points(1.1)).is_negligible);
    EXPECT_EQ(one_of(settled_points(1.1)).finding, Finding::holds);
}

// NIST StRD, NoInt1: y = B x, SSE (residual) 127.272727272727, SSR (of the regression, about zero)
// 200457.727272727, B = 2.07438016528926.
TEST(FittedForm, SumsOfSquaresHaveTheNamesOfTheField) {
    std::vector<double> x, y;
    for (int i = 0; i <= 10; ++i) {
        x.push_back(60 + i);
        y.push_back(130 + i);
    }
    const auto form = fit_form("y = B x", {"B"}, {x}, y, 0.95, 3);
    EXPECT_NEAR(form->fit.parameters[0].value, 2.07438016528926, 1e-13);
    EXPECT_NEAR(form->of_left_side.residual, 127.272727272727, 1e-9);
    EXPECT_NEAR(form->fit.residual_sum_of_squares, 127.272727272727, 1e-9);
    EXPECT_NEAR(form->fit.explained_sum_of_squares, 200457.727272727, 1e-7);
    StudyFit fit;
    fit.points = settled_points(1.5);
    for (RollingPoint& p : fit.points) p.values[&quantities::settled_shift_ratio].value *= 1.01;
    evaluate(fit);
    const auto json = nlohmann::json::parse(fit_json(fit))["kappa"][0]["constant"];
    const auto document = fit_document(fit);
    for (const auto& section : document.sections)
        for (const report::DocumentTable& table : section.tables) {
            if (table.id != "kappa_fits") continue;
            for (std::size_t k = 0; k < table.columns.size(); ++k) {
                const std::string& heading = table.columns[k].heading;
                const double value =
                    heading.starts_with("SS") ? std::get<double>(table.rows[0][k]) : 0;
                if (heading == "SSE") {
                    EXPECT_EQ(value, json["residual_sum_of_squares"].get<double>());
                }
                if (heading == "SSR") {
                    EXPECT_EQ(value, json["explained_sum_of_squares"].get<double>());
                }
            }
        }
}

TEST(StudyFit, RelaxationIsSaidInEveryOutput) {
    StudyFit fit;
    fit.points = settled_points(1.5);
    fit.caveat = relaxing_caveat();
    evaluate(fit);
    EXPECT_EQ(nlohmann::json::parse(fit_json(fit))["caveat"], fit.caveat);
    EXPECT_NE(points_csv(fit).find(fit.caveat), std::string::npos);
    EXPECT_NE(fits_csv(fit).find(fit.caveat), std::string::npos);
    const auto verdicts = fit_document(fit).verdicts;
    EXPECT_EQ(verdicts.at(0).sentence, fit.caveat);
    for (const report::Verdict& verdict : verdicts)
        EXPECT_EQ(verdict.sentence.find("the thesis' "), std::string::npos) << verdict.sentence;
}

}  // namespace
}  // namespace tricontact::comparisons::one_mapping_test
