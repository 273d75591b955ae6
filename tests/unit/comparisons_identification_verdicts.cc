#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "comparisons/identification_report.h"

namespace tricontact::comparisons {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

IdentifiedModel model(const std::string& name, double young, Interval young_interval,
                      double friction, Interval friction_interval) {
    IdentifiedModel m;
    m.name = name;
    m.found.best = {young, friction};
    m.found.young = PropertyEstimate{young, 0, {}, young_interval};
    m.found.friction = PropertyEstimate{friction, 0, {}, friction_interval};
    m.found.confidence = .95;
    return m;
}

std::vector<Verdict> verdicts_of(const IdentifiedModel& half_space, const IdentifiedModel& layer) {
    IdentificationStudy study;
    study.models = {half_space, layer};
    study.thickness_ratio = .83;
    return identification_verdicts(study);
}

TEST(IdentificationVerdicts, SayHowFarTheHalfSpaceIsOff) {
    const auto verdicts = verdicts_of(model("half-space", 5.7e6, {5.6e6, 5.8e6}, .54, {.53, .55}),
                                      model("layer", 4.2e6, {4.1e6, 4.3e6}, .57, {.56, .58}));
    ASSERT_EQ(verdicts.size(), 2U);
    EXPECT_EQ(verdicts[0].sentence,
              "layer: E = 4.20 MPa (4.10 MPa to 4.30 MPa), mu = 0.570 (0.560 to 0.580); intervals "
              "of 95 %, from the likelihood. This is the model that leaves out least.");
    EXPECT_EQ(verdicts[1].standing, Verdict::Standing::fails);
    EXPECT_EQ(verdicts[1].sentence,
              "The half-space finds E = 5.70 MPa, layer 4.20 MPa: 36 % too high; the layer is 0.83 "
              "contact widths thick; its mu is 5.3 % too low.");
}

TEST(IdentificationVerdicts, SayNothingThatTheMeasurementDoesNot) {
    const auto verdicts = verdicts_of(model("half-space", 5.7e6, {3e6, 8e6}, .9, {.4, infinity}),
                                      model("layer", 4.2e6, {2e6, 6e6}, .9, {.4, infinity}));
    EXPECT_EQ(verdicts[0].sentence.substr(0, 58),
              "layer: E = 4.20 MPa (2.00 MPa to 6.00 MPa), mu above 0.400");
    EXPECT_EQ(verdicts[1].standing, Verdict::Standing::cannot_tell);
    EXPECT_EQ(std::ranges::count(verdicts, Verdict::Standing::cannot_tell, &Verdict::standing), 3);
}

TEST(IdentificationVerdicts, AThickLayerIsAHalfSpace) {
    const auto verdicts = verdicts_of(model("half-space", 5.01e6, {4.9e6, 5.1e6}, .5, {.4, .6}),
                                      model("layer", 5e6, {4.9e6, 5.1e6}, .5, {.4, .6}));
    EXPECT_EQ(verdicts[1].standing, Verdict::Standing::holds);
}

}  // namespace
}  // namespace tricontact::comparisons
