#include "comparisons/bodies/body_deviation.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/comparisons/history.h"

namespace tricontact::body_deviation_test {
namespace {

using namespace comparisons;
using contact::Case;
using contact::ElasticBody;

Case hemisphere(const std::vector<std::string>& models) {
    Case c = synthetic::unit_case();
    c.indenter.body = ElasticBody{};
    c.models = models;
    return c;
}

/// A half-space that carries less force, more of a shift.
std::vector<Results> results() {
    std::vector<Results> list(2);
    list[0].model = "bem";
    list[1].model = "fem";
    const auto set = [&](const Quantity& q, double half_space, double body) {
        list[0].set(q, half_space);
        list[1].set(q, body);
    };
    set(quantities::normal_force, 4, 5);
    set(quantities::indentation, 1, 1);
    set(quantities::contact_radius, .99, 1);
    set(quantities::unit_shift, .6, .5);
    set(quantities::tangential_ratio, .5, .5);
    set(quantities::static_shift, .3, .25);
    set(quantities::limit_tangential_ratio, .8, .75);
    set(quantities::settled_shift, .44, .4);
    return list;
}

bool says(const std::vector<std::string>& sentences, const std::string& part) {
    return std::ranges::any_of(
        sentences, [&](const std::string& s) { return s.find(part) != std::string::npos; });
}

/// Whose half widths a synthetic pair of meshes gives.
NumericalError error_of(const Case& c, const Results& fine, const Quantity& q, double coarser) {
    NumericalError error{.model = fine.model};
    ResolvedRun run(c, synthetic::loaded_history(fine.model));
    run.results = fine;
    error.run = error.coarser = run;
    error.coarser->results.set(q, coarser);
    return error;
}

TEST(BodyDeviation, PairsABodyWithTheHalfSpaceThatTakesLeastElseForGranted) {
    const auto pair = body_pair(hemisphere({"mdr", "bem", "fem"}));
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->body, "fem");
    EXPECT_EQ(pair->half_space, "bem");
    EXPECT_FALSE(body_pair(hemisphere({"bem"})));
    EXPECT_FALSE(body_pair(hemisphere({"fem"})));
    EXPECT_FALSE(body_pair(hemisphere({"fem-axisymmetric", "fem"})));
    Case rigid = hemisphere({"bem", "fem"});
    rigid.indenter.body.reset();
    EXPECT_FALSE(body_pair(rigid));
    // A layer: bem-layer takes the indenter alone for a half-space.
    Case layer = hemisphere({"bem", "bem-layer", "fem"});
    layer.layer.thickness = 1;
    EXPECT_EQ(body_pair(layer)->half_space, "bem-layer");
}

TEST(BodyDeviation, IsHalfSpaceOverBodyOfWhatIsNotPrescribed) {
    Case c = hemisphere({"bem", "fem"});
    c.load.normal_force.reset();
    c.load.indentation = 1;
    LoadingStudy study;
    study.tangential_stiffness = {{"bem", 2}, {"fem", 2.5}};
    const auto found = body_deviation(c, results(), study, {});
    ASSERT_TRUE(found);
    const auto json = body_deviation_json(*found)["quantities"];
    EXPECT_NEAR(json["normal_force_N"]["deviation"].get<double>(), -.2, 1e-15);
    EXPECT_NEAR(json["tangential_stiffness_N_per_m"]["deviation"].get<double>(), -.2, 1e-15);
    EXPECT_NEAR(json["unit_shift_m"]["deviation"].get<double>(), .2, 1e-15);
    EXPECT_FALSE(json.contains("indentation_m")) << "prescribed";
    EXPECT_TRUE(json["normal_force_N"]["deviation_half_width"].is_null()) << "no errors known";
    const auto sentences = body_deviation_sentences(c, *found);
    EXPECT_TRUE(says(sentences, "normal force F_N −20.0 %")) << sentences.front();
    EXPECT_FALSE(says(sentences, "takes for granted")) << "nothing else";
    EXPECT_FALSE(says(sentences, "Less than what meshes"));
    EXPECT_FALSE(says(sentences, "Nothing holds"));
}

TEST(BodyDeviation, RollingHasALimitAndASettledShift) {
    Case c = hemisphere({"bem", "fem"});
    const bool rolls = c.rolling.has_value();
    c.rolling = Case::Rolling{};
    const auto rolled = body_deviation_json(*body_deviation(c, results(), {}, {}))["quantities"];
    EXPECT_NEAR(rolled["limit_tangential_ratio"]["deviation"].get<double>(), .8 / .75 - 1, 1e-15);
    EXPECT_NEAR(rolled["settled_shift_m"]["deviation"].get<double>(), .1, 1e-15);
    c.rolling.reset();
    const auto stands = body_deviation_json(*body_deviation(c, results(), {}, {}))["quantities"];
    EXPECT_FALSE(stands.contains("limit_tangential_ratio")) << rolls;
}

TEST(BodyDeviation, BarsOfBothAddUp) {
    Case c = hemisphere({"bem", "fem"});
    const auto both = results();
    const auto errors = std::vector{error_of(c, both[0], quantities::contact_radius, .99 - .002),
                                    error_of(c, both[1], quantities::contact_radius, 1 - .003)};
    const auto found = body_deviation(c, both, {}, errors);
    const auto json = body_deviation_json(*found)["quantities"]["contact_radius_m"];
    // Three times what separates two meshes.
    EXPECT_NEAR(json["body_half_width"].get<double>(), .009, 1e-12);
    EXPECT_NEAR(json["deviation_half_width"].get<double>(), .99 * (.006 / .99 + .009), 1e-12);
    // .01 of .015: not told.
    const auto sentences = body_deviation_sentences(c, *found);
    EXPECT_TRUE(says(sentences, "Less than what meshes and steps leave: contact radius"));
    EXPECT_FALSE(says({sentences.front()}, "contact radius"));
}

TEST(BodyDeviation, WhatElseIsTakenForGrantedIsSaid) {
    Case c = hemisphere({"bem", "fem"});
    c.layer.thickness = 1;
    EXPECT_TRUE(says(body_deviation_sentences(c, *body_deviation(c, results(), {}, {})),
                     "indenter as half-space, half-space"));
    c.indenter.body->support = ElasticBody::Support::plates;
    EXPECT_TRUE(says(body_deviation_sentences(c, *body_deviation(c, results(), {}, {})),
                     "Nothing holds a body between plates"));
    c.indenter.body->support = ElasticBody::Support::pressure;
    EXPECT_TRUE(says(body_deviation_sentences(c, *body_deviation(c, results(), {}, {})),
                     "held at the face that the pressure loads"));
}

TEST(BodyDeviation, DepthsInPlaneStrainAreNotDefinite) {
    Case c = hemisphere({"bem", "fem"});
    const auto sentences = [&] {
        return body_deviation_sentences(c, *body_deviation(c, results(), {}, {}));
    };
    EXPECT_FALSE(says(sentences(), "logarithm"));
    c.indenter.shape = Case::Shape::cylinder;
    EXPECT_TRUE(says(sentences(), "logarithm of its length"));
}

TEST(BodyDeviation, WithoutATangentialLoadThereIsNoShift) {
    Case c = hemisphere({"bem", "fem"});
    auto pressed = results();
    for (Results& r : pressed) r.set(quantities::tangential_ratio, 1e-20);
    const auto json = body_deviation_json(*body_deviation(c, pressed, {}, {}))["quantities"];
    EXPECT_FALSE(json.contains("static_shift_m"));
    EXPECT_TRUE(json.contains("unit_shift_m"));
}

}  // namespace
}  // namespace tricontact::body_deviation_test
