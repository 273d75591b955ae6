#include "comparisons/bodies/body_sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "comparisons/bodies/size_output.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"
#include "fem/settings.h"

namespace tricontact::body_sizes_test {
namespace {

using namespace comparisons;
using contact::Case;
using contact::ElasticBody;

constexpr double radius = 10e-3, young = 2e6;

Case ball_case(double poisson = .3) {
    Case c;
    c.models = {"bem", "fem"};
    c.indenter.shape = Case::Shape::sphere;
    c.indenter.radius = radius;
    c.indenter.material = contact::Material{young, poisson};
    c.indenter.body = ElasticBody{};
    c.has_rigid_substrate = true;
    c.friction.coefficient = .5;
    c.load.indentation = 4e-4;  // a/R = 0.2
    c.load.tangential_ratio = .5;
    return c;
}

Case cylinder_case() {
    Case c = ball_case();
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.length = 80e-3;
    c.indenter.body =
        ElasticBody{ElasticBody::Form::cylinder, ElasticBody::Support::hub, .6 * radius};
    c.load.indentation.reset();
    c.load.normal_force = 4;
    return c;
}

std::string refusal(const Case& c) {
    try {
        size_contact(c);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// A body whose force is 1 + c a/R of Hertz', each coarser mesh off by `coarse`.
std::vector<std::optional<Results>> stiffer(const SizeContact& contact, double c, double coarse) {
    std::vector<std::optional<Results>> results;
    for (const SizeRun& run : size_runs(contact)) {
        const Case one = size_case(contact, run);
        const double e = young / (1 - run.body.poisson * run.body.poisson);
        const double d = *one.load.indentation, a = std::sqrt(radius * d);
        Results r;
        r.set(quantities::indentation, d);
        r.set(quantities::contact_radius, a);
        r.set(quantities::peak_pressure, 2 / std::numbers::pi * e * a / radius);
        r.set(quantities::normal_force, 4. / 3 * e * std::sqrt(radius) * std::pow(d, 1.5) *
                                            (1 + c * a / radius + (run.level == 0 ? coarse : 0)));
        results.emplace_back(r);
    }
    return results;
}

TEST(BodySizes, RunsHaveHertzContactOfTheirSize) {
    const SizeContact contact = size_contact(ball_case());
    EXPECT_NEAR(contact.size, .2, 1e-15);
    const std::vector<SizeRun> runs = size_runs(contact);
    EXPECT_EQ(runs.front().body, contact.own) << "the case's body comes first";
    const Case c = size_case(contact, {.body = contact.own, .size = .1, .level = 1});
    EXPECT_EQ(c.models, std::vector<std::string>{"fem-axisymmetric"});
    EXPECT_NEAR(*c.load.indentation, 1e-4, 1e-15);
    EXPECT_NEAR(*c.of<fem::Settings>().size, 1e-3 / 32, 1e-15);
    EXPECT_EQ(*c.load.tangential_ratio, 0);
    // Line: a^2 = 4 F R/(pi E* L), Johnson (1985), ch. 4.
    const SizeContact line = size_contact(cylinder_case());
    const double e = young / (1 - .3 * .3);
    EXPECT_NEAR(line.size, std::sqrt(4 * 4. / (std::numbers::pi * e * 80e-3 * radius)), 1e-12);
    const Case strip = size_case(line, {.body = line.own, .size = .1, .level = 0});
    EXPECT_NEAR(std::sqrt(4 * *strip.load.normal_force * radius /
                          (std::numbers::pi * e * strip.indenter.length)),
                .1 * radius, 1e-12);
}

TEST(BodySizes, AKnownDeviationHasItsLimits) {
    const SizeContact contact = size_contact(ball_case());
    const SizeDeviation deviation = size_deviation(contact, stiffer(contact, .5, .002));
    EXPECT_EQ(deviation.n_failed_runs, 0u);
    const auto& points = deviation.curves.front().points.at(&size_measures().front());
    // Straight lines are their own interpolants.
    const SizeLimits limits = size_limits(points);
    EXPECT_NEAR(*limits[0]->at, .02, 1e-9);
    EXPECT_NEAR(*limits[2]->at, .1, 1e-9);
    // 1.25 of .002: .05 -+ .0025 over .5.
    EXPECT_NEAR(*limits[2]->low, .095, 1e-6);
    EXPECT_NEAR(*limits[2]->high, .105, 1e-6);
    const auto json = nlohmann::json::parse(size_json("0", "", deviation));
    EXPECT_NEAR(json["here"]["normal_force_at_equal_depth"]["ratio"].get<double>(), 1.1, 1e-12);
    const std::string sentence = size_verdicts(deviation).front().sentence;
    EXPECT_NE(sentence.find("% above a half-space's here, at a/R = 0.200"), std::string::npos)
        << sentence;
    EXPECT_NE(sentence.find("within 5 % up to a/R = 0.100 (0.0950 to 0.105)"), std::string::npos)
        << sentence;
    EXPECT_EQ(sentence.find("Failed"), std::string::npos);
    // What never deviates is not said to do so from somewhere on.
    EXPECT_NE(size_verdicts(deviation)[1].sentence.find("as far as was looked"), std::string::npos);
}

TEST(BodySizes, FailedRunsAreToldAndLeaveTheOthers) {
    const SizeContact contact = size_contact(ball_case());
    auto results = stiffer(contact, .5, 0);
    results[2].reset();
    const SizeDeviation deviation = size_deviation(contact, results);
    EXPECT_EQ(deviation.n_failed_runs, 1u);
    EXPECT_NE(size_verdicts(deviation).back().sentence.find("Failed runs: 1"), std::string::npos);
    EXPECT_NEAR(*size_limits(deviation.curves[0].points.at(&size_measures()[0]))[2]->at, .1, 1e-9);
}

TEST(BodySizes, RefusesWhatHasNoSize) {
    Case c = ball_case();
    c.indenter.body.reset();
    EXPECT_TRUE(refusal(c).starts_with("indenter.body is missing")) << refusal(c);
    c = ball_case();
    c.has_rigid_substrate = false;
    EXPECT_TRUE(refusal(c).starts_with("substrate.rigid")) << refusal(c);
    c = ball_case();
    c.load.indentation = 2e-3;  // a/R = 0.45
    EXPECT_NE(refusal(c).find("reduce the load"), std::string::npos) << refusal(c);
    c = cylinder_case();
    c.load.normal_force.reset();
    c.load.indentation = 1e-4;
    EXPECT_TRUE(refusal(c).starts_with("load.indentation")) << refusal(c);
    c = ball_case();
    c.indenter.body->form = ElasticBody::Form::punch;
    EXPECT_TRUE(refusal(c).starts_with("indenter.body")) << refusal(c);
}

}  // namespace
}  // namespace tricontact::body_sizes_test
