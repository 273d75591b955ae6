#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/records/experiment_evaluation.h"
#include "experiments/records/experiment_report.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments::experiment_errors_test {
namespace {

using contact::State;
using tests::SyntheticRecord;

constexpr double um = 1e-6;

// A rig sets a force and a length. mu and F_N drawn at random, the cubic solved by bisection.
TEST(Experiment, RatiosOfTheCaseStandForTheForceAndTheLengthThatTheRigSets) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = 0.56;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = 0.24;
    std::mt19937_64 random(8);
    auto e = tests::evaluated(SyntheticRecord(), random);
    normalise(e, c,
              {{"friction.coefficient", 0.02,
                [](contact::Case& k) -> double& { return *k.friction.coefficient; }},
               {"load.normal_force", 0.1,
                [](contact::Case& k) -> double& { return *k.load.normal_force; }}});
    const auto& r = *e.normalised;
    EXPECT_NEAR(r.tangential_ratio.value, 0.56, 1e-15);
    EXPECT_NEAR(r.tangential_ratio.standard_error / 0.56, std::hypot(0.02 / 0.57, 0.1 / 21.1),
                1e-7);
    std::normal_distribution<double> gauss;
    double sum = 0, squares = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double mu = 0.57 + 0.02 * gauss(random), force = 21.1 + 0.1 * gauss(random);
        const double ratio = 0.56 * 0.57 * 21.1 / (mu * force);
        double low = 0, high = 1;
        while (high - low > 1e-12) {
            const double w = (low + high) / 2;
            (1 - 1.5 * w + 0.5 * w * w * w > ratio ? low : high) = w;
        }
        sum += low;
        squares += low * low;
    }
    const double deviation = std::sqrt((squares - sum * sum / n) / n);
    // A deviation of 20000 draws scatters by 0.5 %; the second order adds some (0.02/0.57)^2.
    EXPECT_NEAR(r.exact_limit.standard_error / deviation, 1, 0.02);
    const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
    const contact::Case set = as_the_rig_sets(
        c, hertz.friction_limit, contact::rolling_amplitude(*c.rolling, hertz.contact_radius));
    EXPECT_NEAR(*set.load.tangential_force, 0.56 * 0.57 * 21.1, 1e-12);
    EXPECT_NEAR(*set.rolling->amplitude, 0.24 * contact::half_space_scales(c).contact_radius,
                1e-15);
    EXPECT_FALSE(set.load.tangential_ratio || set.rolling->amplitude_ratio);
}

// nu = 1/2 is the end of what there is. U_max = mu (E*/G*) d with E*/G* = (2 - nu)/(2 (1 - nu)) and
// d ~ (1 - nu^2)^(2/3): d ln U_max/d nu = 1/(1 - nu) - 1/(2 - nu) - 4/3 nu/(1 - nu^2) = 4/9.
TEST(Experiment, AnErrorAtTheEndOfARangeGoesInwards) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_force = 6.7;
    std::mt19937_64 random(8);
    auto e = tests::evaluated(SyntheticRecord(), random);
    normalise(e, c,
              {{"substrate.poisson", 0.01,
                [](contact::Case& k) -> double& { return k.substrate.poisson; }, 0.5}});
    const auto& unit = e.normalised->unit_shift;
    // Mirrored at its end the function bends there: steps of 0.9 % of nu leave 1e-3 of the slope.
    EXPECT_NEAR(unit.standard_error / unit.value, 0.01 * 4 / 9, 1e-3 * 0.01);
}

// Of a shear strength w_lim is where (2/pi) [arccos w - w (1 - w^2)^(1/2)] = F_T/(tau_0 pi a^2):
// .74706 at w = .2. F_lim goes with E^(-2/3), so that f_T does with E^(2/3).
TEST(Experiment, ALawOfFrictionHasItsOwnLimits) {
    contact::Case c;
    c.indenter.radius = 0.01;
    c.substrate = {1.8e6, 0.5};
    c.friction.shear_strength = 0.35e6;
    c.load.normal_force = 0.5;
    c.load.tangential_ratio = 0.74706;
    std::mt19937_64 random(8);
    auto e = tests::evaluated(SyntheticRecord(), random);
    normalise(
        e, c,
        {{"substrate.young", 18e3, [](contact::Case& k) -> double& { return k.substrate.young; }}});
    const auto& r = *e.normalised;
    EXPECT_NEAR(r.tangential_ratio.value, .74706, 1e-12);
    EXPECT_NEAR(r.tangential_ratio.standard_error / .74706, .01 * 2 / 3, 1e-5);
    EXPECT_NEAR(r.exact_limit.value, .2, 1e-5);
    const double radius = contact::half_space_scales(c).contact_radius;
    EXPECT_NEAR(r.exact_limit_amplitude.value, .2 * radius, 1e-5 * radius);
    EXPECT_FALSE(r.is_coulomb);
    const std::string text = experiment_json("1", e, {});
    EXPECT_NE(text.find("\"thesis_amplitude_limit\": {\n      \"value\": null"), std::string::npos);
}

std::string sentences(const ExperimentEvaluation& e) {
    std::string all;
    for (const report::Verdict& verdict : experiment_verdicts(e)) all += verdict.sentence + '\n';
    return all;
}

TEST(Experiment, WithoutStatedErrorsNobodyTellsWhetherModelsDiffer) {
    std::mt19937_64 random(9);
    auto e = tests::evaluated(SyntheticRecord(), random);
    std::vector<double> shift;
    for (const statistics::Estimate& u : e.shift) shift.push_back(1.1 * u.value);
    add_prediction(e, {"mdr", shift, State::shakedown, 0, {}});
    for (const Deviation& d : e.deviations) EXPECT_FALSE(d.differs());
    const std::string text = sentences(e);
    EXPECT_EQ(text.find("they differ\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("± 0 "), std::string::npos) << text;
    EXPECT_NE(text.find("states no uncertainty of its numbers"), std::string::npos) << text;
}

// Of a relaxing substrate: what F_T did before the record began is no difference of the models, nor
// is the drift that was taken out of the record with the creep.
TEST(Experiment, RestAndCreepOfARelaxingSubstrateAreNoDifference) {
    std::mt19937_64 random(9);
    auto e = tests::evaluated(SyntheticRecord(), random);
    EXPECT_DOUBLE_EQ(e.rest.time, 30);
    EXPECT_FALSE(e.rest.is_whole);
    Experiment loaded;
    loaded.loading = 10;
    SyntheticRecord with_loading;
    with_loading.unloaded = 10;
    loaded.records = {with_loading.make(random)};
    const auto whole = evaluate_experiment(loaded);
    EXPECT_DOUBLE_EQ(whole.rest.time, 30);  // of 40 s before the rolling, 10 without the load
    EXPECT_TRUE(whole.rest.is_whole);

    std::vector<double> shift;
    for (const statistics::Estimate& u : e.shift) shift.push_back(1.1 * u.value);
    const ModelPrediction prediction{"mdr", shift, State::shakedown, 0, {shift}};
    e.rolled_as = {.hold = 30, .hold_is_known = false, .speed = 1e-3};
    add_prediction(e, prediction);
    EXPECT_FALSE(e.deviations[0].differs());
    EXPECT_NE(sentences(e).find("the record does not say when F_T was applied"), std::string::npos);

    e.deviations.clear();
    e.rolled_as.hold_is_known = true;
    add_prediction(e, prediction);
    EXPECT_EQ(e.deviations[0].differs(), std::optional(true));
    EXPECT_EQ(e.deviations[1].differs(), std::optional(true));  // 0.1 um of drift, 10 um apart
    e.deviations.clear();
    e.runs[0].drift.value = 1.1 * um / (12 * 4.) * 10;  // 11 um in twelve periods of 4 s
    add_prediction(e, prediction);
    EXPECT_EQ(e.deviations[0].differs(), std::optional(true));
    EXPECT_FALSE(e.deviations[1].differs());
    EXPECT_NE(sentences(e).find("creep of the substrate"), std::string::npos);
}

/// A prediction of 10 % less than measured, whose number is good for 1 %.
ModelPrediction smaller(const ExperimentEvaluation& e) {
    ModelPrediction p{"mdr", {}, State::shakedown, 0, {{}}};
    for (const statistics::Estimate& u : e.shift) {
        p.shift.push_back(.9 * u.value);
        p.raised[0].push_back(.909 * u.value);
    }
    return p;
}

// Just below its limit a contact that shifts by 1 % per standard error may shift by 20 % at the end
// of 95 %: that is what the interval then reaches to, and both fates are said.
TEST(Experiment, NearItsLimitACaseIsNotJudgedByItsSlope) {
    std::mt19937_64 random(9);
    auto e = tests::evaluated(SyntheticRecord(), random);
    ModelPrediction far = smaller(e), near = smaller(e), sliding = smaller(e);
    near.ends = {near.shift, near.shift};
    for (double& u : near.ends[1]) u *= 1.2;
    near.chance_of_ratcheting = .31;
    sliding.slides_within = true;
    far.ends = {far.shift, far.shift};
    for (double& u : far.ends[1]) u *= 1.02;  // as its slope says
    add_prediction(e, far);
    EXPECT_EQ(sentences(e).find("the limit lies within"), std::string::npos);
    EXPECT_EQ(sentences(e).find(nonlinear_response), std::string::npos);
    add_prediction(e, near);
    add_prediction(e, sliding);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(e.deviations[i].differs(), std::optional(true));
        EXPECT_EQ(e.deviations[2 + i].differs(), std::optional(false));
        EXPECT_EQ(e.deviations[4 + i].differs(), std::nullopt);
    }
    EXPECT_EQ(e.series[0].differs(), std::optional(true));
    EXPECT_EQ(e.series[1].differs(), std::optional(false));
    EXPECT_EQ(e.series[2].differs(), std::nullopt);
    const std::string text = sentences(e);
    EXPECT_NE(text.find("the limit lies within the uncertainty of the case. Shakedown and "
                        "ratcheting are both possible, ratcheting with a chance of some 31 %"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("and the contact slides"), std::string::npos) << text;
    EXPECT_NE(text.find(nonlinear_response), std::string::npos) << text;
}

// Steps are a source as the mesh is: 10 % of the shift by them cover 10 % of difference.
TEST(Experiment, StepsAreASourceOfUncertainty) {
    std::mt19937_64 random(9);
    auto e = tests::evaluated(SyntheticRecord(), random);
    ModelPrediction p = smaller(e);
    for (const double u : p.shift) p.steps_error.push_back(.1 * u);
    add_prediction(e, p);
    for (const Deviation& d : e.deviations) {
        EXPECT_EQ(d.differs(), std::optional(false));
        EXPECT_EQ(d.error.shares().front().first, "steps");
    }
    EXPECT_EQ(e.series[0].differs(), std::optional(false));
}

// Of several runs the increment is their mean with the scatter's interval, not that of one run's
// noise.
TEST(Experiment, RatchetingOfRepeatsHasTheIntervalOfTheirScatter) {
    std::mt19937_64 random(9);
    Experiment experiment;
    experiment.kind = Experiment::Kind::ratcheting;
    for (const double increment : {5., 5.2, 5.4}) {
        SyntheticRecord synthetic;
        synthetic.stages[0].increment = increment;
        experiment.records.push_back(synthetic.make(random));
    }
    const auto e = evaluate_experiment(experiment);
    const Estimate increment = increment_of_runs(e);
    EXPECT_NEAR(increment.value, 5.2 * um, .02 * um);
    // 4.303 times .2/sqrt(3) um.
    EXPECT_NEAR(increment.half_width(), 4.303 * .2 / std::sqrt(3.) * um, .06 * um);
    EXPECT_NE(sentences(e).find("5.2 ± 0.5 µm per period (95 %, by the scatter of the runs)"),
              std::string::npos)
        << sentences(e);
}

}  // namespace
}  // namespace tricontact::experiments::experiment_errors_test
