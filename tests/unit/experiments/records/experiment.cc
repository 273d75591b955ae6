#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "experiments/records/experiment_evaluation.h"
#include "statistics/estimate.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments::experiment_test {
namespace {

using contact::State;
using tests::SyntheticRecord;

constexpr double um = 1e-6;

double scatter(double p, int n) {  // three standard deviations of the binomial
    return 3 * std::sqrt(p * (1 - p) / n);
}

// A vibrometer whose zero and drift are in the record.
SyntheticRecord whole_record() {
    SyntheticRecord synthetic;
    synthetic.unloaded = 10;
    synthetic.zero = 20;
    synthetic.noise = 0.12;  // above the resolution: rounding averages out
    return synthetic;
}
Experiment settings() {
    Experiment experiment;
    experiment.resolution = 80e-9;
    experiment.loading = 10;
    return experiment;
}

bool holds(const statistics::Estimate& e, double truth) {
    return e.low <= truth && truth <= e.high;
}

TEST(ExperimentRunSlow, IntervalsOfOneRunCoverTheTruthAsOftenAsTheyClaim) {
    constexpr int n_runs = 100;
    std::mt19937_64 random(1);
    for (const double correlation : {0., 0.7}) {
        SyntheticRecord synthetic = whole_record();
        synthetic.correlation = correlation;
        int n_static = 0, n_final = 0, n_drift = 0, n_middle = 0, n_increment[2] = {0, 0};
        for (int i = 0; i < n_runs; ++i) {
            Experiment experiment = settings();
            experiment.records = {synthetic.make(random)};
            const auto e = evaluate_experiment(experiment);
            const auto& truth = synthetic.stages[0];
            n_static += holds(e.static_shift.at_95, um * truth.shift(0));
            n_final += holds(e.final_shift.at_95, um * truth.shift(12));
            n_middle += holds(e.shift[5], um * truth.shift(5));
            // Where the drift's error is small in the values, and where it is most of it.
            n_increment[0] += holds(e.period_increments[1], um * (truth.shift(2) - truth.shift(1)));
            n_increment[1] +=
                holds(e.period_increments[11], um * (truth.shift(12) - truth.shift(11)));
            n_drift += std::abs(e.runs[0].drift.value - um * synthetic.drift) <
                       e.runs[0].drift.standard_error;
            EXPECT_EQ(e.state, State::shakedown);
        }
        // Estimated correlations are too small by some per cent in a rest of 300 samples: their
        // intervals may cover 5 % less than they claim.
        const double lost = correlation > 0 ? 0.05 : 0;
        EXPECT_NEAR(n_static / double(n_runs), 0.95, scatter(0.95, n_runs) + lost);
        EXPECT_NEAR(n_final / double(n_runs), 0.95, scatter(0.95, n_runs) + lost);
        // No fewer than claimed. More by what widens them on purpose: Birge's ratio R of two drifts
        // that are normal and equally well known is |N(0, 1)|, so that max(1, R) standard errors of
        // their mean, which R does not depend on, hold in (1 + p^2)/2 of the cases, p = .683; and a
        // slow part of the noise that the rest cannot exclude widens by up to 8 % in the mean of
        // white rests (coverage_factor): P(|z| < 1.08) = .720, with Birge's ratio .768.
        constexpr double claimed = .683, by_birge = (1 + claimed * claimed) / 2, by_memory = .720,
                         by_both = .768;
        const auto between = [&](int n, double most) {
            EXPECT_GE(n / double(n_runs), claimed - scatter(claimed, n_runs) - lost);
            EXPECT_LE(n / double(n_runs), most + scatter(most, n_runs));
        };
        between(n_middle, by_both);
        between(n_drift, by_birge);
        between(n_increment[0], by_memory);
        between(n_increment[1], by_both);
    }
}

TEST(ExperimentRun, FindsWobbleNoiseAndResolution) {
    std::mt19937_64 random(2);
    SyntheticRecord synthetic;
    const auto run = tests::evaluated(synthetic, random).runs[0];
    EXPECT_NEAR(run.noise.resolution, 80e-9, 1e-15);
    // Noise and rounding, sqrt(50^2 + 80^2/12) = 55 nm; 600 samples give it to 3 %.
    EXPECT_NEAR(run.noise.standard_deviation, 55.1e-9, 5e-9);
    EXPECT_NEAR(run.wobble->value, 0.0015, 4 * run.wobble->standard_error);
    EXPECT_LT(run.wobble->standard_error, 0.1 * 0.0015);
    EXPECT_FALSE(run.drift_changes);
}

// The table's wobble is some 30 times the resolution, the values do not see it, nor at which times
// samples were taken.
TEST(ExperimentRun, WobbleAndJitterDoNotReachTheValuesOfPeriods) {
    SyntheticRecord synthetic;
    synthetic.drift = synthetic.noise = synthetic.resolution = 0;
    for (const double jitter : {0., 0.4}) {
        synthetic.wobble = 0.0025;
        synthetic.jitter = jitter;
        std::mt19937_64 random(1);
        const auto e = tests::evaluated(synthetic, random);
        for (std::size_t n = 0; n < e.shift.size(); ++n)
            EXPECT_NEAR(e.shift[n].value, um * synthetic.stages[0].shift(double(n)), 1e-15);
    }
}

TEST(ExperimentSlow, MeansOfRepeatsCoverTheTruthAsOftenAsTheyClaim) {
    constexpr int n_sets = 80;
    std::mt19937_64 random(5);
    std::normal_distribution<double> gauss(0, 3);
    int n_68 = 0, n_95 = 0, n_increment = 0;
    for (int i = 0; i < n_sets; ++i) {
        Experiment experiment = settings();
        experiment.kind = Experiment::Kind::ratcheting;
        for (int run = 0; run < 3; ++run) {
            SyntheticRecord synthetic = whole_record();
            synthetic.sampling = 0.1;
            synthetic.stages[0].increment = 4 + 0.1 * gauss(random);
            synthetic.stages[0].limit = 100 + gauss(random);  // contacts differ from run to run
            experiment.records.push_back(synthetic.make(random));
        }
        const auto e = evaluate_experiment(experiment);
        EXPECT_EQ(e.state, State::ratcheting);
        n_68 += holds(e.static_shift.at_confidence, 60 * um);
        n_95 += holds(e.static_shift.at_95, 60 * um);
        // What is left of the transient adds 0.09 um to the slope of the second half.
        n_increment += holds(e.increment.at_confidence, 4.09 * um);
    }
    EXPECT_NEAR(n_68 / double(n_sets), 0.683, scatter(0.683, n_sets));
    EXPECT_NEAR(n_95 / double(n_sets), 0.95, scatter(0.95, n_sets));
    EXPECT_NEAR(n_increment / double(n_sets), 0.683, scatter(0.683, n_sets));
}

// Amplitudes of 1, 1.1, ... mm; the contact ratchets from 1.25 mm on.
SyntheticRecord limit_record() {
    SyntheticRecord synthetic;
    synthetic.stages.clear();
    double shift = 60;
    for (double amplitude = 1000; amplitude < 1450; amplitude += 100) {
        const double increment = amplitude > 1250 ? 0.05 * (amplitude - 1250) : 0;
        SyntheticRecord::Stage stage{.amplitude = amplitude,
                                     .periods = 10,
                                     .limit = shift + 10,
                                     .transient = 10,
                                     .ratio = 0.4,
                                     .increment = increment};
        synthetic.stages.push_back(stage);
        shift = stage.shift(10);
    }
    return synthetic;
}

TEST(ExperimentLimit, LiesBetweenTheLastShakedownAndTheFirstRatcheting) {
    std::mt19937_64 random(6);
    Experiment experiment;
    experiment.kind = Experiment::Kind::limit;
    for (int run = 0; run < 3; ++run) experiment.records.push_back(limit_record().make(random));
    const auto e = evaluate_experiment(experiment);
    ASSERT_EQ(e.limits.size(), 3U);
    for (const auto& limit : e.limits) {
        ASSERT_TRUE(limit);
        EXPECT_NEAR(limit->amplitude_low, 1.2e-3, 1e-5);
        EXPECT_NEAR(limit->amplitude_high, 1.3e-3, 1e-5);
    }
    EXPECT_TRUE(holds(e.limit_amplitude->at_95, 1.25e-3));
    EXPECT_LT(e.limit_amplitude->at_95.high - e.limit_amplitude->at_95.low, 0.11e-3);
    EXPECT_NEAR(e.last_shakedown->at_95.value, 1.2e-3, 1e-5);
}

// One run: the limit lies anywhere between its two stages with equal probability, the half width
// over sqrt(3) is the standard error (JCGM 100:2008, 4.3.7).
TEST(ExperimentLimit, StandardErrorIsThatOfAnEvenDistribution) {
    std::mt19937_64 random(6);
    Experiment experiment;
    experiment.kind = Experiment::Kind::limit;
    experiment.records = {limit_record().make(random)};
    const auto one = evaluate_experiment(experiment);
    const double half = (one.limits[0]->amplitude_high - one.limits[0]->amplitude_low) / 2;
    EXPECT_NEAR(one.limit_amplitude->at_confidence.standard_error, half / std::sqrt(3.), 1e-15);
    EXPECT_NEAR(one.limit_amplitude->at_95.high - one.limit_amplitude->at_95.low, 2 * half, 1e-15);
    // Equal repeats share the steps of the amplitude: nothing averages out.
    experiment.records.push_back(experiment.records[0]);
    const auto two = evaluate_experiment(experiment);
    EXPECT_NEAR(two.limit_amplitude->at_95.standard_error, half / std::sqrt(3.), 1e-15);
}

TEST(ExperimentLimit, IntersectionOfStraightLinesIsExactAndItsErrorThatOfTheFormula) {
    // U = 90 + 0.1 t until 40 s, then 94 + 0.8 (t - 40), in um and s.
    std::mt19937_64 random(7);
    constexpr int n_sets = 400;
    int n_covered = 0;
    for (const double noise : {0., 0.05}) {
        std::normal_distribution<double> gauss(0, 1);
        for (int i = 0; i < n_sets; ++i) {
            StageEvaluation before, after;
            for (int n = 0; n <= 10; ++n) {
                before.time.push_back(4. * n);
                before.shift.push_back(um * (90 + 0.4 * n + noise * gauss(random)));
                after.time.push_back(40 + 4. * n);
                after.shift.push_back(um * (94 + 3.2 * n + noise * gauss(random)));
            }
            const auto lines = intersect(before, after, 0.683);
            if (noise == 0) {
                EXPECT_NEAR(lines.time, 40, 1e-9);
                EXPECT_NEAR(lines.shift.value, 94 * um, 1e-15);
            }
            n_covered += noise > 0 && holds(lines.shift, 94 * um);
        }
    }
    // Student's t of one line's nine degrees of freedom is a little wide for two lines.
    EXPECT_NEAR(n_covered / double(n_sets), 0.683, scatter(0.683, n_sets) + 0.02);
    StageEvaluation flat;
    for (int n = 0; n <= 5; ++n) {
        flat.time.push_back(n);
        flat.shift.push_back(um * (n % 2));
    }
    EXPECT_TRUE(std::isnan(intersect(flat, flat, 0.95).shift.low));
}

TEST(Experiment, NormalisedErrorsAreThoseOfTheFormulas) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_force = 6.7;
    std::mt19937_64 random(8);
    auto e = tests::evaluated(SyntheticRecord(), random);
    normalise(e, c,
              {{"friction.coefficient", 0.02,
                [](contact::Case& k) -> double& { return *k.friction.coefficient; }},
               {"load.normal_force", 0.1,
                [](contact::Case& k) -> double& { return *k.load.normal_force; }}});
    // f_T = F_T/(mu F_N); U_max = mu (E*/G*) d with d ~ F_N^(2/3), a ~ F_N^(1/3).
    const double mu = 0.02 / 0.57, force = 0.1 / 21.1;
    const auto& r = *e.normalised;
    EXPECT_NEAR(r.tangential_ratio.standard_error / r.tangential_ratio.value, std::hypot(mu, force),
                1e-7);
    EXPECT_NEAR(r.unit_shift.standard_error / r.unit_shift.value, std::hypot(mu, force * 2 / 3),
                1e-7);
    EXPECT_NEAR(r.amplitude_ratio.standard_error / r.amplitude_ratio.value, force / 3, 1e-7);
    // d(1 - 3/2 w + 1/2 w^3) = -3/2 (1 - w^2) dw.
    const double w = r.exact_limit.value;
    EXPECT_NEAR(1 - 1.5 * w + 0.5 * w * w * w, r.tangential_ratio.value, 1e-12);
    EXPECT_NEAR(r.exact_limit.standard_error,
                r.tangential_ratio.standard_error / (1.5 * (1 - w * w)), 1e-7);
    EXPECT_NEAR(r.thesis_limit.value, 1 - r.tangential_ratio.value, 1e-15);
    const double own = e.final_shift.at_95.standard_error / e.final_shift.at_95.value;
    EXPECT_NEAR(r.final_ratio.standard_error / r.final_ratio.value,
                std::hypot(mu, force * 2 / 3, own), 1e-7);
    // 5.1.11: the wobble of 1.5 um per mm is a pivot 0.0015 R = 60 um too high, half of it if a
    // model has the other half itself.
    const auto height = pivot_height(e, 0), rest = pivot_height(e, 0.00075);
    EXPECT_NEAR(height.value, 60 * um, 4 * height.standard_error);
    EXPECT_NEAR(height.value - rest.value, 30 * um, 1e-15);
}

TEST(Experiment, ModelsDifferOnlyIfIntervalsExcludeEachOther) {
    std::mt19937_64 random(9);
    Experiment experiment;
    experiment.records = {SyntheticRecord().make(random)};
    auto e = evaluate_experiment(experiment);
    std::vector<double> shift;
    for (int n = 0; n <= 12; ++n) shift.push_back(um * 1.1 * experiment.records[0].shift[0]);
    for (int n = 0; n <= 12; ++n) shift[std::size_t(n)] = 1.1 * e.shift[std::size_t(n)].value;
    std::vector<double> raised = shift;
    for (double& u : raised) u *= 1.2;
    add_prediction(e, {"mdr", shift, State::shakedown, 0, {shift}});  // errors that do nothing
    add_prediction(e, {"bem", shift, State::shakedown, 0, {raised}});
    ASSERT_EQ(e.deviations.size(), 4U);
    for (const Deviation& d : e.deviations) {
        EXPECT_NEAR(d.ratio(), 1 / 1.1, 1e-12);
        EXPECT_EQ(d.differs(), std::optional(d.model == "mdr"));
    }
}

TEST(Experiment, RefusesRecordsThatSayTooLittle) {
    const auto refusal = [](const SyntheticRecord& synthetic, Experiment experiment = {}) {
        std::mt19937_64 random(1);
        experiment.records.push_back(synthetic.make(random));
        try {
            evaluate_experiment(experiment);
        } catch (const contact::InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    SyntheticRecord synthetic;
    synthetic.stages[0].periods = 4;
    EXPECT_EQ(refusal(synthetic).substr(0, 57),
              "run.csv: there are 4 periods from 30 s on, fewer than 5; ");
    synthetic = {};
    synthetic.rest_before = 1;
    EXPECT_EQ(
        refusal(synthetic),
        "run.csv: there are 20 samples of rest under load before rolling begins at 1 s, fewer "
        "than 30; record the static shift longer");
    EXPECT_EQ(refusal(limit_record()).substr(0, 63),
              "run.csv: the amplitude changes from 1 mm to 1.1 mm at 70 s; eva");
    synthetic = {};
    synthetic.stages[0].amplitude = 1100;
    std::mt19937_64 random(1);
    Experiment other;
    other.records = {SyntheticRecord().make(random)};
    EXPECT_EQ(refusal(synthetic, other).substr(0, 51),
              "run.csv: the amplitude is 1.1 mm, but 1 mm in run.c");
}

TEST(Experiment, WobbleOfAModelIsWhatFollowsTheDrive) {
    contact::Case c;
    c.rolling.emplace();
    c.rolling->angle = std::acos(-1.) / 2;
    contact::History history;
    for (int k = 0; k <= 8; ++k) {
        const double phase = 0.25 * k, w = SyntheticRecord::triangle(phase - std::floor(phase));
        contact::StepRecord step;
        step.phase = phase;
        step.offset = {0, 2e-3 * w};
        step.shift = {(k < 4 ? 9 : 5) * um + 2 * um * phase - 0.003 * step.offset[1], 0};
        history.steps.push_back(step);
    }
    EXPECT_NEAR(model_wobble(history.steps, history.steps.back().phase - 1, c.rolling->angle),
                -0.003, 1e-12);
}

// Two repeats: t = 1.837 at 68.3 %, 12.71 at 95 % (DIN 1319-3, table F.2: 1.84, 12.71).
TEST(Repeats, FollowStudent) {
    const statistics::Estimate e = statistics::mean_of({1, 3}, 0.95);
    EXPECT_EQ(e.value, 2);
    EXPECT_NEAR(e.standard_error, 1, 1e-15);
    EXPECT_NEAR(e.high, 2 + 12.706, 1e-3);
    EXPECT_NEAR(statistics::mean_of({1, 3}, 0.683).high, 2 + 1.839, 2e-3);
    EXPECT_THROW(statistics::mean_of({1}, 0.95), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::experiments::experiment_test
