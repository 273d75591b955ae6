#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "experiments/identification/identification_report.h"
#include "report/format.h"

namespace tricontact::experiments::identification_verdicts_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

IdentifiedModel model(const std::string& name, double young, Interval young_interval,
                      double friction, Interval friction_interval) {
    IdentifiedModel m;
    m.name = name;
    m.found.free = {young_parameter(young), friction_parameter(.4)};
    m.found.parameters = {{{young}, young_interval}, {{friction}, friction_interval}};
    m.found.logarithmic.standard_errors = {.01, .01};
    m.found.confidence = .95;
    return m;
}

std::vector<report::Verdict> verdicts_of(const IdentifiedModel& half_space,
                                         const IdentifiedModel& layer) {
    IdentificationStudy study;
    study.models = {half_space, layer};
    study.thickness_ratio = .83;
    return identification_verdicts(study);
}

TEST(IdentificationVerdicts, SayHowFarTheHalfSpaceIsOff) {
    const auto verdicts = verdicts_of(model("half-space", 5.7e6, {5.6e6, 5.8e6}, .54, {.53, .55}),
                                      model("layer", 4.2e6, {4.1e6, 4.3e6}, .57, {.56, .58}));
    ASSERT_EQ(verdicts.size(), 3U);
    EXPECT_EQ(
        verdicts[0].sentence,
        "layer: E = 4.20 MPa (4.10 MPa to 4.30 MPa), mu = 0.570 (0.560 to 0.580); intervals "
        "of 95 %, from the likelihood, the rig's data taken as exact. This is the most complete "
        "model.");
    EXPECT_EQ(verdicts[1].standing, report::Verdict::Standing::violated);
    EXPECT_EQ(verdicts[1].sentence,
              "The half-space finds E = 5.70 MPa, layer 4.20 MPa: 36 % too high; the layer is 0.83 "
              "contact widths thick; its mu is 5.3 % too low.");
    EXPECT_EQ(verdicts[2].sentence,
              "Use the values of layer: those of the half-space differ (E by 36 %) by more than "
              "these data resolve.");
}

TEST(IdentificationVerdicts, SayNothingThatTheMeasurementDoesNot) {
    const auto verdicts = verdicts_of(model("half-space", 5.7e6, {3e6, 8e6}, .9, {.4, infinity}),
                                      model("layer", 4.2e6, {2e6, 6e6}, .9, {.4, infinity}));
    EXPECT_EQ(verdicts[0].sentence.substr(0, 58),
              "layer: E = 4.20 MPa (2.00 MPa to 6.00 MPa), mu above 0.400");
    EXPECT_EQ(verdicts[1].standing, report::Verdict::Standing::not_resolved);
    EXPECT_EQ(std::ranges::count(verdicts, report::Verdict::Standing::not_resolved,
                                 &report::Verdict::standing),
              3);
}

TEST(IdentificationVerdicts, AThickLayerIsAHalfSpace) {
    const auto verdicts = verdicts_of(model("half-space", 5.01e6, {4.9e6, 5.1e6}, .5, {.4, .6}),
                                      model("layer", 5e6, {4.9e6, 5.1e6}, .5, {.4, .6}));
    EXPECT_EQ(verdicts[1].standing, report::Verdict::Standing::holds);
    EXPECT_EQ(verdicts.back().sentence.substr(0, 24), "The half-space suffices:");
}

TEST(IdentificationVerdicts, ARejectedModelIsNotUsed) {
    auto half_space = model("half-space", 5.01e6, {4.9e6, 5.1e6}, .5, {.4, .6});
    auto layer = model("layer", 5e6, {4.9e6, 5.1e6}, .5, {.4, .6});
    half_space.found.goodness = .001;
    layer.found.goodness = .3;
    EXPECT_EQ(verdicts_of(half_space, layer).back().sentence,
              "Use the values of layer: chi^2 rejects the half-space.");
    layer.found.goodness = .002;
    EXPECT_EQ(verdicts_of(half_space, layer).back().standing, report::Verdict::Standing::fail);
}

// A pattern of residuals does what chi^2 does of stated errors; beside stated ones that chi^2 finds
// large enough, they are correlated, and the model is used with wider intervals.
TEST(IdentificationVerdicts, WithoutStatedErrorsAPatternRejects) {
    const auto half_space = model("half-space", 5.01e6, {4.9e6, 5.1e6}, .5, {.4, .6});
    auto layer = model("layer", 5e6, {4.9e6, 5.1e6}, .5, {.4, .6});
    layer.found.residuals = {{.has_pattern = true, .has_strong_one = true}};
    IdentificationStudy study;
    study.models = {half_space, layer};
    EXPECT_EQ(
        model_to_use(study)->sentence,
        "None of the values is to be used before the reason is known: the residuals of layer, "
        "the most complete model, show a pattern.");
    study.models[1].found.goodness = .4;
    EXPECT_EQ(model_to_use(study)->sentence.substr(0, 24), "The half-space suffices:");
    study.models = {layer, layer};
    study.models[0].name = "bem-layer";
    study.models[0].found.residuals = {{.has_pattern = true}};
    EXPECT_EQ(model_to_use(study)->sentence,
              "Use the values of bem-layer, the most complete of these models. Without stated "
              "errors no model is tested but by the pattern of its residuals, and those of "
              "bem-layer have one that 5 % of tables have by chance.");
}

// Depths of a sphere: F = 4/3 E* R^(1/2) d^(3/2), so that an error of R moves E by half of it. R of
// the evaluation is the true one and its error, drawn at random, as the forces are.
TEST(IdentificationIntervalsSlow, CoverTheTruthAsOftenAsTheyClaimWithUncertainInputs) {
    constexpr double young = 4e6, radius = 0.04, radius_error = 0.001, force_error = 0.05;
    std::mt19937_64 random(4);
    std::normal_distribution<double> gauss;
    const auto forces = [](double modulus, double r) {
        std::vector<double> all;
        for (int i = 1; i <= 12; ++i)
            all.push_back(4. / 3 * modulus / 0.75 * std::sqrt(r) * std::pow(5e-5 * i, 1.5));
        return all;
    };
    constexpr int n = 400;
    int n_full = 0, n_likelihood = 0;
    for (int k = 0; k < n; ++k) {
        const double assumed = radius + radius_error * gauss(random);
        IdentificationTask task;
        task.parameters = {young_parameter(young)};
        task.tables = {{"depths", forces(young, radius), std::vector<double>(12, force_error)}};
        for (double& force : task.tables[0].observed) force += force_error * gauss(random);
        task.model = [&](const std::vector<double>& v) { return forces(v[0], assumed); };
        IdentifiedModel model;
        model.name = "half-space";
        model.found = identify(task);
        const double found = model.found.best()[0];
        model.contributions = {
            {"indenter.radius", radius_error, {-found / 2 * radius_error / assumed}}};
        const auto holds = [&](const Interval& i) { return i.low <= young && young <= i.high; };
        n_full += holds(full_interval(model, 0));
        n_likelihood += holds(model.found.parameters[0].likelihood);
    }
    // Three standard deviations of 400 trials at 0.95 are 0.033.
    EXPECT_NEAR(n_full / double(n), 0.95, 0.033);
    EXPECT_LT(n_likelihood / double(n), 0.8);
}

TEST(IdentificationIntervals, OpenEndsStayOpenAndErrorsAddInSquares) {
    auto m = model("layer", 4e6, {3.7e6, 4.4e6}, .5, {.4, infinity});
    m.contributions = {{"a", 1, {.3e6, .1}}, {"b", 1, {.4e6, 0}}};
    const double half = 1.959964 * .5e6;  // 0.3 and 0.4 in squares
    const Interval young = full_interval(m, 0);
    EXPECT_NEAR(young.low, 4e6 - std::hypot(.3e6, half), 1);
    EXPECT_NEAR(young.high, 4e6 + std::hypot(.4e6, half), 1);
    const Interval friction = full_interval(m, 1);
    EXPECT_NEAR(friction.low, .5 - std::hypot(.1, .1959964), 1e-6);
    EXPECT_EQ(friction.high, infinity);
    m.contributions = {{"a", 1, {9e6, 0}}};
    EXPECT_EQ(full_interval(m, 0).low, 0);
}

// Both models take the same radius: its error moves both values alike, not one against the other. A
// thickness moves the layer's alone.
TEST(IdentificationVerdicts, SharedErrorsDoNotHideABias) {
    auto half_space = model("half-space", 5.7e6, {5.6e6, 5.8e6}, .54, {.53, .55});
    auto layer = model("layer", 4.2e6, {4.1e6, 4.3e6}, .57, {.56, .58});
    half_space.contributions = {{"indenter.radius", 1e-3, {.57e6, .0}}};
    layer.contributions = {{"indenter.radius", 1e-3, {.42e6, .0}}};
    EXPECT_EQ(verdicts_of(half_space, layer)[1].standing, report::Verdict::Standing::violated);
    layer.contributions = {{"substrate.thickness", 1e-3, {.8e6, .0}}};
    EXPECT_EQ(verdicts_of(half_space, layer)[1].standing, report::Verdict::Standing::not_resolved);
    half_space.contributions = {};
    EXPECT_EQ(verdicts_of(half_space, layer)[1].standing, report::Verdict::Standing::not_resolved);
}

TEST(IdentificationVerdicts, ProbabilitiesAreNoPowersOfTen) {
    auto m = model("layer", 4.2e6, {4.1e6, 4.3e6}, .57, {.56, .58});
    m.found.goodness = 5.6e-287;
    m.found.tables = {{.sum_of_squares = 1344, .degrees_of_freedom = 10, .goodness = 5.6e-287}};
    IdentificationStudy study;
    study.models = {m};
    EXPECT_EQ(
        identification_verdicts(study)[1].sentence,
        "layer does not explain the measurement: chi^2 = 1344 with 10 degrees of freedom, p < "
        "0.001 by chance.");
    EXPECT_EQ(report::p_value(0.0009), "p < 0.001");
    EXPECT_EQ(report::p_value(0.001), "p = 0.0010");
    EXPECT_EQ(report::p_value(0.42), "p = 0.42");
    EXPECT_EQ(report::p_number(0), "< 0.001");
    EXPECT_EQ(report::p_number(std::nan("")), "–");
    EXPECT_EQ(report::share(1e-9), "below 0.001 %");
    EXPECT_EQ(report::share(-1e-9), "below 0.001 %");
    EXPECT_EQ(report::share(0), "0 %");
    EXPECT_EQ(report::share(0.0234), "2.3 %");
}

}  // namespace
}  // namespace tricontact::experiments::identification_verdicts_test
