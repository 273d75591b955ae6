// fit under a shear strength: its own static shift, MDR's own kappa, no formulas of the thesis.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/shakedown/fit_document.h"
#include "comparisons/shakedown/study_fit.h"
#include "tests/unit/comparisons/shakedown/rolling_study.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::comparisons::strength_fit_test {
namespace {

using std::numbers::pi;
using theory::strength_rolling;

double force_of(double u) {
    return 2 / pi * (std::asin(u) + u * std::sqrt(1 - u * u));
}

/// u of f = f_static(u) - kappa w u by bisection.
double shift_of(double w, double f, double kappa) {
    double low = 0, high = std::sqrt(1 - w * w);
    for (int i = 0; i < 60; ++i) {
        const double u = (low + high) / 2;
        (force_of(u) - kappa * w * u < f ? low : high) = u;
    }
    return low;
}

std::vector<RollingPoint> points_of(double kappa, const char* model = "mdr") {
    std::vector<RollingRun> runs;
    for (const double w : amplitudes)
        for (const double f : loads) {
            const double limit = 2 / pi * (std::acos(w) - w * std::sqrt(1 - w * w));
            if (f > limit) continue;
            runs.push_back(rolling_run(model, w, f, contact::State::shakedown));
            runs.back().results.set(quantities::limit_tangential_ratio, limit);
            settle(runs.back().results, shift_of(w, f, kappa));
        }
    return rolling_points(runs);
}

TEST(StrengthFit, GivesItsKappaBack) {
    for (const double kappa : {.8, 1.1, 4 / pi}) {
        const auto groups = mapping_fits(points_of(kappa), .95, strength_rolling);
        ASSERT_TRUE(groups.at(0).constant);
        EXPECT_NEAR(groups[0].constant->fit.parameters[0].value, kappa, 1e-10);
        EXPECT_EQ(groups[0].constant->form,
                  "f_T = 2/pi [arcsin u_sd + u_sd (1 - u_sd^2)^(1/2)] - kappa w u_sd");
        EXPECT_NEAR(groups[0].uses.front().worst, 0, 1e-7);
        ASSERT_EQ(groups[0].uses.size(), 2u);  // fitted, MDR; the thesis has none
        EXPECT_EQ(groups[0].uses[1].name, "mdr");
        EXPECT_NEAR(groups[0].uses[1].kappa, 4 / pi, 1e-15);
    }
    // By Coulomb's static shift it would be no constant.
    const auto wrong = mapping_fits(points_of(1.), .95);
    double least = 9, most = -9;
    for (const MappingPoint& p : wrong.at(0).points) {
        least = std::min(least, p.kappa.value);
        most = std::max(most, p.kappa.value);
    }
    EXPECT_GT(most - least, .5);
}

TEST(StrengthFit, ErrorsOfShiftsBecomeThoseOfKappa) {
    auto points = points_of(1.);
    for (RollingPoint& p : points) p.values[&quantities::settled_shift_ratio].error = 1e-6;
    for (const MappingPoint& p : mapping_fits(points, .95, strength_rolling).at(0).points) {
        const double w = p.at.amplitude_ratio, f = p.at.tangential_ratio;
        const double u = p.at.at(quantities::settled_shift_ratio).value;
        const auto kappa = [=](double at) { return (force_of(at) - f) / (w * at); };
        const double change = kappa(u + 1e-6) - kappa(u - 1e-6);
        EXPECT_NEAR(p.kappa.error, std::abs(change) / 2, 1e-8 + 1e-5 * std::abs(change));
    }
}

TEST(StrengthFit, LimitsOfLensesHaveMdrsKappa) {
    std::vector<LimitPoint> limits;
    for (const double w : amplitudes)
        limits.push_back({w, {2 / pi * (std::acos(w) - w * std::sqrt(1 - w * w)), 0}});
    const auto form = fit_limit(limits, .95, strength_rolling);
    EXPECT_NEAR(form->fit.parameters[0].value, 4 / pi, 1e-12);
}

TEST(StrengthFit, ItsReportHasNothingOfTheThesis) {
    StudyFit fit;
    fit.law = &strength_rolling;
    fit.points = points_of(1.);
    evaluate(fit);
    const auto document = fit_document(fit);
    for (const report::DocumentSection& section : document.sections)
        EXPECT_NE(section.id, "thesis");
    for (const report::Verdict& verdict : document.verdicts)
        EXPECT_EQ(verdict.sentence.find("thesis"), std::string::npos) << verdict.sentence;
    EXPECT_EQ(document.lead.find("thesis"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(fit_json(fit))["friction"], "a shear strength");
}

}  // namespace
}  // namespace tricontact::comparisons::strength_fit_test
