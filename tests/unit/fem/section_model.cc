// Models of sections, of cases.

#include "fem/case/section_model.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

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

Case cylinder(const std::vector<std::string>& changes = {}) {
    return io::parse_case(R"(models = ["fem-plane"]
[indenter]
shape = "cylinder"
radius = "40 mm"
length = "100 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.45
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
normal_force = "50 N"
tangential_ratio = 0.3
[rolling]
amplitude = "1 mm"
[fem]
size = "0.2 mm"
)",
                          "case.toml", changes);
}

/// Shift after a quarter and three quarters of a period [m].
std::array<double, 2> rolled(const Case& c) {
    const auto model =
        fem::make_section_model(contact::model_kind(contact::models::fem_plane), c, nullptr);
    const contact::LoadPath path = contact::make_load_path(c, *c.load.normal_force, 1e-3);
    for (const auto& step : path.pressing) model->advance(step);
    for (const auto& step : path.loading) model->advance(step);
    std::array<double, 2> shift{};
    const std::size_t n = path.period.size();
    for (std::size_t k = 0; k < n; ++k) {
        const double now = model->advance(path.period[k]).shift[0];
        if (k + 1 == n / 4) shift[0] = now;
        if (k + 1 == 3 * n / 4) shift[1] = now;
    }
    EXPECT_TRUE(model->audit().passed());
    return shift;
}

// A cylinder on its hub, a million times as stiff as the layer, rolls as one that is rigid.
TEST(FemSectionModel, AStiffCylinderRollsAsARigidOne) {
    const auto rigid = rolled(cylinder());
    const std::vector<std::string> on_hub{"indenter.body=\"cylinder\"", "indenter.support=\"hub\"",
                                          "indenter.hub_radius=\"20 mm\"", "indenter.poisson=0.45"};
    auto stiff = on_hub, soft = on_hub;
    stiff.emplace_back("indenter.young=\"5200000 MPa\"");
    soft.emplace_back("indenter.young=\"5.2 MPa\"");
    const auto as_stiff = rolled(cylinder(stiff)), as_soft = rolled(cylinder(soft));
    for (const int k : {0, 1}) {
        EXPECT_NEAR(as_stiff[k] / rigid[k], 1, 1e-5);
        EXPECT_GT(as_soft[k] / rigid[k], 1.3);
    }
}

TEST(FemSectionModel, RollsACylinderOnItsHubAlone) {
    const std::vector<std::string> soft{"indenter.young=\"5.2 MPa\"", "indenter.poisson=0.45",
                                        "indenter.body=\"cylinder\""};
    auto plates = soft, far = soft;
    plates.insert(plates.end(), {"indenter.support=\"plates\"", "load.tangential_ratio=0"});
    EXPECT_THROW(cylinder(plates), contact::InputError);
    far.insert(far.end(), {"indenter.support=\"hub\"", "indenter.hub_radius=\"20 mm\"",
                           "rolling.amplitude=\"90 mm\""});
    EXPECT_THROW(cylinder(far), contact::InputError);
}

// FreeFem++ 4.11, P2 elements of a/32, has .306324 N with a penalty that takes .036 %.
TEST(FemSectionModel, PressesABallOnAHub) {
    const Case c = hemisphere({"indenter.body=\"ball\"", "indenter.support=\"hub\"",
                               "indenter.hub_radius=\"3 mm\"", "fem.size=\"0.04 mm\""});
    EXPECT_NEAR(pressed(c)->scales().normal_force / .306434, 1, 6e-4);
}

/// Forces at once and after pauses of these lengths [s], at the depth of the case.
std::vector<double> held_forces(const Case& c, const std::vector<double>& pauses) {
    auto model = fem::make_section_model(contact::model_kind(c.models.front()), c, nullptr);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    step.duration = 0;
    std::vector<double> forces{model->advance(step).normal_force};
    for (const double pause : pauses) {
        step.duration = pause;
        forces.push_back(model->advance(step).normal_force);
    }
    return forces;
}

const std::vector<std::string> indenter_relaxes{"substrate.relaxation.relative_moduli=[0.4]",
                                                "substrate.relaxation.times=[\"0.5 s\"]",
                                                "substrate.relaxation.body=\"indenter\""};

// On a rigid plane all that deforms relaxes: at a depth that is held the force is that of the
// elastic body times G(t)/G_inf.
TEST(FemSectionModel, HemisphereThatRelaxesOnAPlane) {
    const double elastic = pressed(hemisphere())->scales().normal_force;
    const std::vector<double> found = held_forces(hemisphere(indenter_relaxes), {.2, .3, 1});
    constexpr double ratio = .4 / .6;
    double t = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k] / (elastic * (1 + ratio * std::exp(-t / .5))), 1, 1e-9) << k;
        t += std::vector{.2, .3, 1., 0.}[k];
    }
}

// On an elastic layer the pair relaxes from one elastic pair to another.
TEST(FemSectionModel, HemisphereThatRelaxesOnALayer) {
    const std::vector<std::string> on_layer{"substrate.rigid=false", "substrate.young=\"4 MPa\"",
                                            "substrate.poisson=0.3",
                                            "substrate.thickness=\"5 mm\""};
    std::vector<std::string> relaxing = on_layer, stiff = on_layer;
    relaxing.insert(relaxing.end(), indenter_relaxes.begin(), indenter_relaxes.end());
    stiff.push_back("indenter.young=\"3.3333333333333333 MPa\"");
    const std::vector<double> found = held_forces(hemisphere(relaxing), {1, 1e4});
    const double first = held_forces(hemisphere(stiff), {})[0],
                 last = held_forces(hemisphere(on_layer), {})[0];
    EXPECT_NEAR(found[0] / first, 1, 1e-5);
    EXPECT_NEAR(found[2] / last, 1, 1e-5);
    EXPECT_LT(found[1], .95 * first);
    EXPECT_GT(found[1], 1.01 * last);
}

Case pin(const std::vector<std::string>& changes) {
    return io::parse_case(R"(models = ["fem-plane"]
[indenter]
shape = "cylinder"
radius = "10 mm"
length = "20 mm"
young = "2 MPa"
poisson = 0.3
body = "pin"
support = "hub"
hub_radius = "2 mm"
[substrate]
shape = "hole"
hole_radius = "10.05 mm"
[friction]
coefficient = 0.5
[load]
indentation = "0.1 mm"
tangential_ratio = 0
[fem]
size = "1.5 mm"
)",
                          "case.toml", changes);
}

// The same in a hole, whose contact closes around the pin: rigid, and of an elastic plate.
TEST(FemSectionModel, PinThatRelaxesInAHole) {
    const std::vector<std::string> rigid{"substrate.rigid=true"};
    std::vector<std::string> relaxing = rigid;
    relaxing.insert(relaxing.end(), indenter_relaxes.begin(), indenter_relaxes.end());
    const double elastic = held_forces(pin(rigid), {})[0];
    const std::vector<double> alone = held_forces(pin(relaxing), {.2, .3});
    constexpr double ratio = .4 / .6;
    EXPECT_NEAR(alone[0] / (elastic * (1 + ratio)), 1, 1e-9);
    EXPECT_NEAR(alone[1] / (elastic * (1 + ratio * std::exp(-.4))), 1, 1e-9);
    EXPECT_NEAR(alone[2] / (elastic * (1 + ratio * std::exp(-1))), 1, 1e-9);

    const std::vector<std::string> plate{"substrate.young=\"4 MPa\"", "substrate.poisson=0.3",
                                         "substrate.outer_radius=\"100 mm\""};
    std::vector<std::string> stiff = plate;
    stiff.push_back("indenter.young=\"3.3333333333333333 MPa\"");
    relaxing = plate;
    relaxing.insert(relaxing.end(), indenter_relaxes.begin(), indenter_relaxes.end());
    const std::vector<double> found = held_forces(pin(relaxing), {1, 1e4});
    const double first = held_forces(pin(stiff), {})[0], last = held_forces(pin(plate), {})[0];
    EXPECT_NEAR(found[0] / first, 1, 1e-5);
    EXPECT_NEAR(found[2] / last, 1, 1e-5);
    EXPECT_LT(found[1], .95 * first);
    EXPECT_GT(found[1], 1.01 * last);
}

}  // namespace
}  // namespace tricontact::section_model_test
