// Models of sections, of cases.

#include "fem/case/section_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"

namespace tricontact::section_model_test {
namespace {

using contact::Case;
using contact::ModelKind;

const ModelKind& of_revolution() {
    return contact::model_kind(contact::models::fem_axisymmetric);
}

Case hemisphere(const std::vector<std::string>& changes = {}) {
    return io::parse_case(R"(models = ["fem-axisymmetric"]
[indenter]
shape = "sphere"
radius = "10 mm"
young = "2 MPa"
poisson = 0.3
body = "hemisphere"
support = "holder"
[substrate]
rigid = true
[friction]
coefficient = 0.5
[load]
indentation = "0.1 mm"
tangential_ratio = 0
[fem]
size = "0.1 mm"
)",
                          "case.toml", changes);
}

std::unique_ptr<contact::Model> pressed(const Case& c, bool friction = false) {
    auto model = fem::make_section_model(of_revolution(), c, nullptr);
    contact::LoadStep step = contact::press_step(c);
    step.friction = friction;
    model->advance(step);
    return model;
}

// Ten elements across the contact: .1 % in F (.31530 N by an independent program).
TEST(FemSectionModel, PressesAHemisphereOnAPlane) {
    const auto model = pressed(hemisphere());
    EXPECT_EQ(model->name(), contact::models::fem_axisymmetric);
    EXPECT_NEAR(model->scales().normal_force / .31530, 1, 2e-3);
    EXPECT_TRUE(model->audit().passed());
}

// The surface is the section turned about its axis: the same in all directions, the force in its
// pressures (points h/2 apart cut the edge: 2 %).
TEST(FemSectionModel, ShowsItsSurfaceTurnedAboutTheAxis) {
    const auto model = pressed(hemisphere(), true);
    const contact::Surface s = model->surface();
    ASSERT_EQ(s.n_x, s.n_y);
    ASSERT_EQ(s.n_x % 2, 1);
    ASSERT_EQ(s.normal_traction.size(), s.size());
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(j) * s.n_x + i; };
    const int middle = s.n_x / 2;
    EXPECT_NEAR(s.x(middle), 0, 1e-15);
    for (int k = 1; k <= middle; ++k) {
        EXPECT_EQ(s.normal_traction[at(middle + k, middle)],
                  s.normal_traction[at(middle, middle - k)]);
        EXPECT_EQ(s.tangential_traction_x[at(middle + k, middle)],
                  -s.tangential_traction_x[at(middle - k, middle)]);
        EXPECT_EQ(s.tangential_traction_x[at(middle + k, middle)],
                  s.tangential_traction_y[at(middle, middle + k)]);
        EXPECT_EQ(s.tangential_traction_y[at(middle + k, middle)], 0);
    }
    // Without friction p_0 is 143.057 kPa by an independent program; extrapolated to the axis.
    const auto smooth = pressed(hemisphere());
    const contact::Surface frictionless = smooth->surface();
    EXPECT_NEAR(frictionless.normal_traction[at(middle, middle)] / 143057, 1, 5e-3);
    double force = 0;
    for (const double p : frictionless.normal_traction) force += p * s.spacing[0] * s.spacing[1];
    EXPECT_NEAR(force / smooth->scales().normal_force, 1, .02);
}

TEST(FemSectionModel, ChoosesElementsByTheAccuracy) {
    Case c = hemisphere();
    c.of<fem::Settings>().size.reset();
    c.of<fem::Settings>().accuracy.reset();
    const double usual = fem::section_size(of_revolution(), c);
    EXPECT_NEAR(usual, 1.0246e-3 / 24, .05 * usual);  // of the radius on coarse elements
    c.of<fem::Settings>().accuracy = 2e-5;
    EXPECT_LT(fem::section_size(of_revolution(), c), .3 * usual);
}

TEST(FemSectionModel, RefusesLoadsThatAreNoneOfRevolution) {
    const Case c = hemisphere();
    const auto model = pressed(c);
    contact::LoadStep step = contact::press_step(c);
    step.tangential[0].value = 1;
    EXPECT_THROW(model->advance(step), contact::InputError);
    step = contact::press_step(c);
    step.offset = {1e-3, 0};
    EXPECT_THROW(model->advance(step), contact::InputError);
}

TEST(FemSectionModel, RefusesBodiesThatItCannotMesh) {
    const Case deep = hemisphere({"indenter.shape=\"rounded-punch\"", "indenter.radius=\"1 mm\"",
                                  "indenter.flat_radius=\"2 mm\"", "indenter.body=\"punch\"",
                                  "indenter.height=\"10 mm\"", "load.indentation=\"4 mm\""});
    EXPECT_THROW(fem::make_section_model(of_revolution(), deep, nullptr), contact::InputError);
    const Case coarse = hemisphere({"fem.size=\"3 mm\""});
    EXPECT_THROW(fem::make_section_model(of_revolution(), coarse, nullptr), contact::InputError);
}

}  // namespace
}  // namespace tricontact::section_model_test
