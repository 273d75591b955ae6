// Contacts that the solvers once gave up: strong friction that couples, membranes.

#include <gtest/gtest.h>

#include "bem/model.h"
#include "contact/run.h"
#include "io/case/case_reader.h"

namespace tricontact::hard_contacts_test {
namespace {

contact::History run(const std::string& text, bem::Body body) {
    const contact::Case c = io::parse_case(text, "case.toml");
    const auto model = bem::make_model(c, 1, body);
    return contact::run(c, *model);
}

// Nearly sliding at mu beta = 4.3, where each turn multiplies errors by that: on the way friction
// lifts the indenter above the undeformed surface, so that nothing may be measured by its depth.
TEST(HardContacts, StrongFrictionCouples) {
    const auto history = run(R"(
models = ["bem"]
[indenter]
shape = "paraboloid"
radius = "1 m"
[substrate]
young = "1 MPa"
poisson = -0.26
[friction]
coefficient = 7.15
[load]
normal_force = "10 N"
tangential_ratio = 0.99
[bem]
cells_per_radius = 4
)",
                             bem::Body::half_space);
    EXPECT_TRUE(history.audit.passed());
}

// A thin layer that glides on its ground is a membrane: Newton's steps go in circles, gradients
// descend.
TEST(HardContacts, ThinLayerGlidesOnItsGround) {
    const auto history = run(R"(
models = ["bem-layer"]
[indenter]
shape = "paraboloid"
radius = "17.561 mm"
[substrate]
young = "18.83 Pa"
poisson = -0.4317
thickness = "0.1095 mm"
base = "frictionless"
[friction]
coefficient = 0.0011843
[load]
indentation = "1.81398 mm"
tangential_ratio = 0.3657
[bem]
cells_per_radius = 6.283
)",
                             bem::Body::layer);
    EXPECT_TRUE(history.audit.passed());
}

// Next to no friction under a soft cone: its pressure moves the surface tens of thousands of times
// as far as friction could, so that all slips and only the tractions' directions are left to find.
TEST(HardContacts, NextToNoFrictionCouples) {
    const auto history = run(R"(
models = ["bem-layer"]
[indenter]
shape = "cone"
angle = "0.00679 rad"
young = "466.87767 Pa"
poisson = 0.43693
[substrate]
young = "146455136.96074 Pa"
poisson = 0.43425
thickness = "2.06014e-07 m"
base = "bonded"
[friction]
coefficient = 1.27704e-06
[contact]
coupling = true
[load]
normal_force = "4.55055e-11 N"
tangential_ratio = 0.06639
press_steps = 2
[rolling]
amplitude_ratio = 0.04224
angle = "3.14159 rad"
periods = 2
run_all = false
steps_per_quarter = 3
[bem]
cells_per_radius = 6.83607
)",
                             bem::Body::layer);
    EXPECT_TRUE(history.audit.passed());
}

}  // namespace
}  // namespace tricontact::hard_contacts_test
