#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "comparisons/resolution/refinement.h"
#include "comparisons/shakedown/ratcheting_fit.h"
#include "experiments/identification/estimation/identification.h"
#include "experiments/records/experiment_evaluation.h"
#include "tests/unit/comparisons/shakedown/rolling_study.h"
#include "tests/unit/experiments/records/synthetic_record.h"

// Errors by their formulas, where coverage of the truth would not show a wrong one.
namespace tricontact::comparisons::error_bars_test {
namespace {

using experiments::Experiment;
using tests::SyntheticRecord;

// Roache (1994): 1.25 times what the order, here the first, makes of the last change.
TEST(ErrorBars, OfTwoLevels) {
    EXPECT_DOUBLE_EQ(value_of_levels({1, 0.5}, {3, 2.5}).error, 1.25 * 0.5);
    EXPECT_DOUBLE_EQ(value_of_levels({1, 0.25}, {3, 2.5}).error, 1.25 * 0.5 / 3);
}

// Third order is seen, but not trusted.
TEST(ErrorBars, OfAnOrderThatIsTooGoodAreThoseOfTheLargestTrusted) {
    const std::vector<double> sizes{1, 0.5, 0.25}, values{2.3, 2 + 0.3 / 8, 2 + 0.3 / 64};
    const LimitEstimate limit = estimate_limit(sizes, values);
    EXPECT_NEAR(*limit.order, 3, 1e-9);
    const double change = 0.3 / 8 - 0.3 / 64;
    EXPECT_NEAR(limit.error, 1.25 * change / (std::pow(2, largest_trusted_order) - 1), 1e-12);
}

TEST(ErrorBars, OfTheLimitOfTheAmplitudeBecomeThoseOfEta) {
    constexpr double error = 1e-4, du_error = 2e-4, f = 0.5;
    const double limit = theory::amplitude_limit(f);
    std::vector<RollingPoint> points;
    for (const double a : {0.6, 0.8})
        points.push_back(
            {.model = "bem",
             .group = "parallel",
             .point = std::to_string(a),
             .amplitude_ratio = a,
             .tangential_ratio = f,
             .state = contact::State::ratcheting,
             .values = {{&quantities::static_shift_ratio, {0.37, 0}},
                        {&quantities::shift_increment_ratio, {0.3 * a, du_error}},
                        {&quantities::limit_tangential_ratio, {theory::shakedown_limit(a), error}},
                        {&quantities::limit_amplitude_ratio, {limit, error}}}});
    const auto groups = ratcheting_fits(points, 0.95);
    ASSERT_EQ(groups.at(0).points.size(), 2u);
    for (const RatchetingPoint& p : groups.at(0).points) {
        const double a = p.at.amplitude_ratio;
        const auto eta = [&](double du, double at) { return du / (a - at); };
        const double by_limit = eta(0.3 * a, limit + 1e-6) - eta(0.3 * a, limit - 1e-6);
        const double expected = du_error / (a - limit) + by_limit / 2e-6 * error;
        EXPECT_NEAR(p.eta.error, expected, 1e-3 * expected);
    }
}

// The levels agree: what is left is what the run's end left open, in U_max and in metres.
TEST(ErrorBars, OfAShiftThatWasStillSettling) {
    std::vector<RollingRun> runs;
    for (const int level : {0, 1}) {
        runs.push_back(rolling_run("bem", 0.5, 0.2, contact::State::shakedown));
        runs.back().level = level;
        runs.back().results.set(quantities::settled_shift_error_ratio, 1e-4);
    }
    const RollingPoint point = rolling_points(runs).at(0);
    EXPECT_DOUBLE_EQ(point.at(quantities::settled_shift_ratio).error, 1e-4);
    EXPECT_DOUBLE_EQ(point.at(quantities::settled_shift).error, 2e-4);  // U_max = 2
}

// Five periods leave two degrees of freedom, t = 4.3 and not the 3.2 of three.
TEST(ErrorBars, OfAWalkOfFivePeriodsCoverIt) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> gauss(0, 0.05);
    constexpr int n_sets = 400;
    int n_covered = 0;
    for (int i = 0; i < n_sets; ++i) {
        std::vector<double> shift;
        for (int n = 0; n <= 5; ++n)
            shift.push_back(100 - 40 * std::pow(0.5, n) + n + gauss(random));
        const statistics::Estimate e = experiments::fit_settling(shift, 0.95).increment;
        n_covered += e.low <= 1 && 1 <= e.high;
    }
    EXPECT_GT(n_covered / double(n_sets), 0.95 - 3 * std::sqrt(0.95 * 0.05 / n_sets));
}

// A line y = m + b (t - t_c) about its middle has errors s/n^(1/2) and s/S^(1/2) that know nothing
// of each other. Raised by d where they meet, the one line moves that place by b_2/(b_2 - b_1) d,
// the other by b_1/(b_2 - b_1) d.
TEST(ErrorBars, OfAnIntersectionAwayFromTheOrigin) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> gauss(0, 0.05);
    experiments::StageEvaluation stages[2];
    for (int n = 0; n <= 10; ++n) {
        stages[0].time.push_back(4. * n);
        stages[0].shift.push_back(90 + 0.4 * n + gauss(random));
        stages[1].time.push_back(40 + 4. * n);
        stages[1].shift.push_back(80 + 3.2 * n + gauss(random));  // they meet at 60 s
    }
    const experiments::LineIntersection lines = experiments::intersect(stages[0], stages[1], 0.683);
    double variance = 0;
    for (int l = 0; l < 2; ++l) {
        const auto& t = stages[l].time;
        const double middle = t[5], places = 16 * 110, slope = lines.slopes[l];
        double squares = 0, mean = 0;
        for (const double u : stages[l].shift) mean += u / 11;
        for (int n = 0; n <= 10; ++n)
            squares += std::pow(
                stages[l].shift[std::size_t(n)] - mean - slope * (t[std::size_t(n)] - middle), 2);
        const double s2 = squares / 9;
        const double at = s2 / 11 + s2 * std::pow(lines.time - middle, 2) / places;
        const double part = lines.slopes[1 - l] / (lines.slopes[1] - lines.slopes[0]);
        variance += part * part * at;
    }
    EXPECT_NEAR(lines.time, 60, 1);
    EXPECT_NEAR(lines.shift.standard_error, std::sqrt(variance), 1e-6 * std::sqrt(variance));
}

TEST(ErrorBars, OfTheDriftAreThoseOfTheWalk) {
    std::mt19937_64 random(3);
    SyntheticRecord synthetic;
    synthetic.noise = 0.3;
    Experiment experiment;
    experiment.records = {synthetic.make(random)};
    const experiments::RunEvaluation run = experiments::evaluate_experiment(experiment).runs.at(0);
    const experiments::StageEvaluation& stage = run.stages.at(0);
    const statistics::Estimate without =
        experiments::fit_settling(stage.shift, experiments::verdict_confidence).increment;
    const statistics::Estimate& with = stage.settling.increment;
    const double drift = run.noise.coverage_factor(experiments::verdict_confidence) *
                         run.drift.standard_error * stage.period;
    EXPECT_GT(drift, 0);
    EXPECT_NEAR(with.high - with.value, std::hypot(without.high - without.value, drift), 1e-15);
    EXPECT_NEAR(with.value - with.low, std::hypot(without.value - without.low, drift), 1e-15);
}

// Drifts that contradict each other are no samples of one: their plain mean counts, and both stand
// at an end of its error.
TEST(ErrorBars, OfDriftsThatContradictEachOther) {
    std::mt19937_64 random(4);
    Experiment experiment;
    experiment.records = {SyntheticRecord().make(random)};
    experiments::Record& record = experiment.records[0];
    for (std::size_t i = 0; i < record.time.size(); ++i)
        record.shift[i] += 1e-9 * record.time[i] * record.time[i];
    const experiments::RunEvaluation run = experiments::evaluate_experiment(experiment).runs.at(0);
    EXPECT_TRUE(run.drift_changes);
    EXPECT_NEAR(run.drift.standard_error, std::abs(run.after->value - run.before.value) / 2, 1e-15);
}

// Of a model that is linear in E the interval of the likelihood is Student's; the level of a region
// of two is least (1 - c)^(-2/dof), since F of two has a closed quantile.
TEST(ErrorBars, EstimatedFromFewObservationsAreStudents) {
    experiments::IdentificationTask task;
    task.parameters = {experiments::young_parameter(1)};
    task.tables = {{"line", {1.1, 1.9, 3.2, 3.9}, {}}};
    task.model = [](const std::vector<double>& v) {
        return std::vector<double>{v[0], 2 * v[0], 3 * v[0], 4 * v[0]};
    };
    const experiments::Identification found = experiments::identify(task);
    ASSERT_EQ(found.degrees_of_freedom, 3);
    const experiments::ParameterEstimate& young = found.parameters[0];
    const double half = 3.182446 * young.standard_error;
    EXPECT_NEAR(young.likelihood.high, young.value + half, 1e-6);
    EXPECT_NEAR(young.likelihood.low, young.value - half, 1e-6);
    EXPECT_NEAR(found.level_of_pair(0, 0) / found.sum_of_squares, std::pow(0.05, -2. / 3), 1e-9);
}

}  // namespace
}  // namespace tricontact::comparisons::error_bars_test
