// A body between two plates that are not alike.

#include "fem/case/plates_model.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "fem/case/section_model.h"
#include "io/case/case_reader.h"

namespace tricontact::plates_model_test {
namespace {

using contact::Case;

const std::string ball = R"(models = ["fem-axisymmetric"]
[indenter]
shape = "sphere"
radius = "10 mm"
young = "2 MPa"
poisson = 0.3
body = "ball"
support = "plates"
[friction]
coefficient = 0.5
[contact]
coupling = false
[load]
indentation = "0.1 mm"
tangential_ratio = 0
[fem]
size = "0.16 mm"
)";
const std::string on_plane = "[substrate]\nrigid = true\n";
const std::string on_layer =
    "[substrate]\nyoung = \"4 MPa\"\npoisson = 0.45\nthickness = \"5 mm\"\n";
const std::string under_plane = "[upper_plate]\nrigid = true\n";
const std::string under_layer =
    "[upper_plate]\nyoung = \"4 MPa\"\npoisson = 0.45\nthickness = \"5 mm\"\n";
const std::vector<std::string> cylinder{"indenter.shape=\"cylinder\"", "indenter.body=\"cylinder\"",
                                        "indenter.length=\"100 mm\""};

struct Both {
    contact::Scales lower, upper;
    double energy;
};

Both press(const std::string& text, std::vector<std::string> changes, bool plane = false) {
    if (plane) {
        changes.insert(changes.end(), cylinder.begin(), cylinder.end());
        changes.emplace_back("models=[\"fem-plane\"]");
    }
    const Case c = io::parse_case(text, "case.toml", changes);
    const auto model = fem::make_section_model(contact::model_kind(c.models.front()), c, nullptr);
    const contact::StepRecord record = model->advance(contact::press_step(c));
    EXPECT_TRUE(model->audit().passed()) << text;
    return {model->scales(), model->upper_scales().value_or(contact::Scales{}),
            record.stored_energy};
}

void expect_same(const contact::Scales& a, const contact::Scales& b, double within) {
    EXPECT_NEAR(a.normal_force / b.normal_force, 1, within);
    EXPECT_NEAR(a.contact_radius / b.contact_radius, 1, within);
    EXPECT_NEAR(a.peak_pressure / b.peak_pressure, 1, within);
    EXPECT_NEAR(a.indentation / b.indentation, 1, within);
}

// The model by symmetry is half of the body; its energy is that of one half.
TEST(FemPlatesModelSlow, EqualPlatesAreTheModelBySymmetry) {
    for (const bool plane : {false, true})
        for (const auto& [below, above] :
             {std::pair(on_plane, under_plane), std::pair(on_layer, under_layer)}) {
            const Both unlike = press(ball + below + above, {}, plane);
            const Both alike = press(ball + below, {}, plane);
            expect_same(unlike.lower, alike.lower, 1e-6);
            expect_same(unlike.upper, alike.lower, 1e-6);
            EXPECT_NEAR(unlike.energy / alike.energy, 2, 1e-6);
        }
}

// Turned upside down it is the same body.
TEST(FemPlatesModel, WhatIsAboveMayBeBelow) {
    for (const bool plane : {false, true}) {
        const std::vector<std::string> load{plane ? "load.normal_force=\"4 N\""
                                                  : "load.normal_force=\"0.3 N\""};
        const Both one = press(ball + on_plane + under_layer, load, plane);
        const Both other = press(ball + on_layer + under_plane, load, plane);
        expect_same(one.lower, other.upper, 1e-6);
        expect_same(one.upper, other.lower, 1e-6);
        EXPECT_NEAR(one.energy / other.energy, 1, 1e-6);
        EXPECT_GT(one.upper.contact_radius, 1.05 * one.lower.contact_radius);
    }
}

// At a/R = .01 each contact is Hertz' (1882) with its own E*, within a/R (.6 % of F in the depth of
// one between equal plates), on a layer of 2000 contact radii.
TEST(FemPlatesModel, IsTheSumOfBothContactsOfHertz) {
    const double force = 4. / 3 * 2e6 / .91 * std::pow(.1e-3, 3) / 10e-3;
    const Both both =
        press(ball + on_plane +
                  "[upper_plate]\nyoung = \"1 MPa\"\npoisson = 0.4\nthickness = \"200 mm\"\n",
              {fmt::format("load.normal_force=\"{:.17g} N\"", force), "fem.size=\"12.5 um\""});
    const double below = 2e6 / .91, above = 1 / (.91 / 2e6 + .84 / 1e6);
    for (const auto& [scales, modulus] :
         {std::pair(both.lower, below), std::pair(both.upper, above)}) {
        const double a = std::cbrt(.75 * force * 10e-3 / modulus);
        EXPECT_NEAR(scales.normal_force / force, 1, 1e-9);
        EXPECT_NEAR(scales.contact_radius / a, 1, 4e-3);
        EXPECT_NEAR(scales.indentation / (a * a / 10e-3), 1, 6e-3);
        EXPECT_NEAR(scales.peak_pressure / (1.5 * force / (std::numbers::pi * a * a)), 1, 6e-3);
    }
}

// The force over the approach of both plates works what is stored: the integral of the power law
// through two neighbouring states each, from F ~ D^(3/2) on.
TEST(FemPlatesModel, StoresTheWorkOfBothPlates) {
    const Case c =
        io::parse_case(ball + on_layer + under_plane, "case.toml", {"fem.size=\"0.1 mm\""});
    const auto model = fem::make_section_model(contact::model_kind(c.models.front()), c, nullptr);
    double work = 0, last_force = 0, last_approach = 0;
    contact::StepRecord record;
    for (const double share : {.3, .4, .5, .6, .7, .8, .9, 1.}) {
        contact::LoadStep step = contact::press_step(c);
        step.normal.value *= share;
        record = model->advance(step);
        const double force = record.normal_force,
                     approach = record.indentation + model->upper_scales()->indentation;
        const double power = last_force > 0
                                 ? std::log(force / last_force) / std::log(approach / last_approach)
                                 : 1.5;
        if (last_force == 0)
            work = record.stored_energy;
        else
            work += (force * approach - last_force * last_approach) / (power + 1);
        last_force = force;
        last_approach = approach;
    }
    EXPECT_NEAR(work / record.stored_energy, 1, 3e-4);
}

// A run that goes on from a state has the same next step.
TEST(FemPlatesModel, GoesOnFromItsState) {
    const Case c = io::parse_case(ball + on_layer + under_plane, "case.toml", {});
    const auto make = [&] {
        return fem::make_section_model(contact::model_kind(c.models.front()), c, nullptr);
    };
    const auto model = make();
    contact::LoadStep step = contact::press_step(c);
    model->advance(step);
    const auto resumed = make();
    resumed->read_state(model->write_state());
    step.normal.value *= .6;
    EXPECT_EQ(model->advance(step).normal_force, resumed->advance(step).normal_force);
    const auto fresh = model->sibling({.coupling = false});
    fresh->advance(step);
    EXPECT_NEAR(fresh->scales().normal_force / model->scales().normal_force, 1, 1e-6);
    EXPECT_EQ(model->sibling({.coupling = true}), nullptr);
}

}  // namespace
}  // namespace tricontact::plates_model_test
