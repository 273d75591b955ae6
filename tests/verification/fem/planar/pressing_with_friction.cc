// Pressing with friction on a half-space, of revolution: Spence (1968, 1975). What sticks is the
// same under a sphere as under a flat punch, whatever the load.

#include <gtest/gtest.h>

#include <cmath>

#include "contact/load_path.h"
#include "contact/model.h"
#include "fem/case/section_model.h"
#include "io/case/case_reader.h"

namespace tricontact::pressing_with_friction_test {
namespace {

struct Spence {
    double poisson, friction, stick_radius, force;  // over a, and over the force without friction
};

contact::Case case_of(const Spence& s) {
    contact::Case c = io::parse_case(R"(models = ["fem-axisymmetric"]
[indenter]
radius = "100 mm"
[substrate]
young = "5 MPa"
poisson = 0.3
thickness = "2 m"
[friction]
coefficient = 0.2
[load]
indentation = "0.1 mm"
press_steps = 40
tangential_ratio = 0
)",
                                     "case.toml");
    c.substrate.poisson = s.poisson;
    c.friction.coefficient = s.friction;
    return c;
}

contact::StepRecord pressed(const contact::Case& c, bool friction) {
    const auto& kind = contact::model_kind(contact::models::fem_axisymmetric);
    const auto model = fem::make_section_model(kind, c, nullptr);
    contact::StepRecord record;
    const int n = friction ? c.load.press_steps : 1;
    for (int k = 1; k <= n; ++k) {
        contact::LoadStep step = contact::press_step(c);
        step.friction = friction;
        step.in_proportion = true;
        step.normal.value *= static_cast<double>(k) / n;
        record = model->advance(step);
    }
    EXPECT_TRUE(model->audit().passed());
    return record;
}

// Reference: c/a by Abel's equation, 1e-4; the force of a sphere by another program's finite
// elements on two meshes. Points are a/48 apart: c/a within two of them; forces by the sphere's 40
// steps, 1e-3.
TEST(FemPlanarPressingWithFriction, SticksInsideSpencesRadius) {
    for (const Spence& s : {Spence{.3, .2, .6983, 1.0119}, Spence{.3, .3, .8960, 1.0147},
                            Spence{0, .3, .5032, 1.0321}}) {
        const contact::Case c = case_of(s);
        const contact::StepRecord with = pressed(c, true), without = pressed(c, false);
        EXPECT_NEAR(std::sqrt(with.stick_area / with.contact_area), s.stick_radius, .02)
            << s.poisson << ' ' << s.friction;
        EXPECT_NEAR(with.normal_force / without.normal_force, s.force, 1e-3)
            << s.poisson << ' ' << s.friction;
    }
}

}  // namespace
}  // namespace tricontact::pressing_with_friction_test
