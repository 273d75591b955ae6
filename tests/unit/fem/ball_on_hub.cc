// A ball that rolls to and fro about its hub in three dimensions.

#include <gtest/gtest.h>

#include <string>

#include "contact/load_path.h"
#include "fem/case/model.h"
#include "io/case/case_reader.h"

namespace tricontact::ball_on_hub_test {
namespace {

const std::string path = R"([friction]
coefficient = 0.5
[path]
table = """
indentation [mm], offset_x [mm]
0.1, 0
0.1, 0.5
"""
[fem]
size = "0.5 mm"
)";

const std::string layer = "[substrate]\nyoung = \"4 MPa\"\npoisson = 0.3\nthickness = \"5 mm\"\n";

std::unique_ptr<contact::Model> model_of(const std::string& indenter,
                                         const std::string& substrate) {
    return fem::make_model(
        io::parse_case("models = [\"fem\"]\n[indenter]\nshape = \"sphere\"\nradius = \"10 mm\"\n" +
                           indenter + substrate + path,
                       "case.toml", {}),
        nullptr);
}

std::string ball(const std::string& young) {
    return "young = \"" + young +
           "\"\npoisson = 0.3\nbody = \"ball\"\nsupport = \"hub\"\nhub_radius = \"3 mm\"\n";
}

contact::StepRecord advanced(contact::Model& model, double offset, bool friction) {
    contact::LoadStep step;
    step.normal = {contact::NormalControl::Kind::indentation, .1e-3};
    step.offset = {offset, 0};
    step.friction = friction;
    return model.advance(step);
}

// By whole elements the patch is the same: about the axis of rolling by construction, but for what
// lies beyond it. .30651 N by the section of this body (Young's modulus 2 MPa), half of the
// contact's radius an element.
TEST(FemBallOnHub, IsAsStiffWhereverItHasRolled) {
    const auto model = model_of(ball("2 MPa"), "[substrate]\nrigid = true\n");
    const double upright = advanced(*model, 0, false).normal_force;
    EXPECT_NEAR(upright / .30651, 1, 2e-2);
    for (const double offset : {.5e-3, -.5e-3})
        EXPECT_NEAR(advanced(*model, offset, false).normal_force / upright, 1, 3e-4) << offset;
}

TEST(FemBallOnHub, RollsAsARigidSphereWhereItIsStiff) {
    const auto stiff = model_of(ball("2 TPa"), layer), rigid = model_of("", layer);
    for (const bool friction : {false, true})
        for (const double offset : {0., .5e-3}) {
            const auto one = advanced(*stiff, offset, friction),
                       other = advanced(*rigid, offset, friction);
            EXPECT_NEAR(one.normal_force / other.normal_force, 1, 1e-4);
            EXPECT_NEAR(one.shift[0], other.shift[0], 1e-4 * one.indentation);
        }
}

}  // namespace
}  // namespace tricontact::ball_on_hub_test
