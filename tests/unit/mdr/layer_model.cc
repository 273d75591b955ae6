#include "mdr/layer_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "contact/base/error.h"
#include "contact/run.h"

namespace tricontact::layer_model_test {
namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;

Case layer_case() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, 0.5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .56;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .24;
    c.rolling->periods = 2;
    return c;
}

LoadStep step(double x, double force) {
    LoadStep s;
    s.offset = {x, 0};
    s.normal = {NormalControl::Kind::force, 21.1};
    s.tangential[0] = {TangentialControl::Kind::force, force};
    return s;
}

std::string message(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

TEST(MdrLayerModel, RefusesCasesThatItCannotDo) {
    auto with = [](auto change) {
        Case c = layer_case();
        change(c);
        return message([&] { mdr::make_layer_model(c, 20); });
    };
    EXPECT_EQ(with([](Case&) {}), "no error");
    EXPECT_EQ(with([](Case& c) { c.layer.thickness.reset(); }),
              "mdr-layer: substrate.thickness is missing; give the thickness of the layer");
    EXPECT_EQ(with([](Case& c) { c.layer.base = Case::Base::frictionless; }),
              "mdr-layer: nothing holds a layer on a frictionless base against a tangential force; "
              "take base = \"bonded\" or another model");
    EXPECT_EQ(with([](Case& c) { c.rolling->amplitude_ratio = 60; }),
              "mdr-layer: the bed would have 2521 elements, more than 2001; shorten the rolling "
              "path or take bem-layer");
    EXPECT_NE(with([](Case& c) {
                  c.substrate.poisson = .4;
                  c.relaxation = contact::Relaxation{{{.2, 1}}, contact::Relaxation::Bulk::elastic};
              }).find("mdr-layer has one relaxation function"),
              std::string::npos);
}

TEST(MdrLayerModel, RefusesStepsThatItCannotTake) {
    const auto model = mdr::make_layer_model(layer_case(), 20);
    auto with = [&](auto change) {
        LoadStep s = step(0, 0);
        change(s);
        return message([&] { model->advance(s); });
    };
    EXPECT_EQ(with([](LoadStep& s) { s.tangential[1].value = 1e-3; }),
              "mdr-layer: a tangential force or shift across the load (y) is not possible in a "
              "spring bed, which has one direction; set it to zero");
    EXPECT_EQ(with([](LoadStep& s) { s.offset[1] = 1e-3; }),
              "mdr-layer: the rolling offset (0, 0.001) m lies off the line of rolling, along "
              "which alone a spring bed extends");
    EXPECT_EQ(with([](LoadStep& s) { s.offset[0] = 4e-3; }),
              "mdr-layer: the contact reaches the last element at phase 0");
    EXPECT_NE(with([](LoadStep& s) { s.tangential[0].value = 15; }).find("friction limit"),
              std::string::npos);
}

TEST(MdrLayerModel, SaysWhenTheRimIsReached) {
    Case c = layer_case();
    c.indenter.shape = Case::Shape::sphere;
    c.indenter.radius = 5e-3;
    c.load.normal_force = 1;
    c.rolling->amplitude_ratio = 3;
    const auto model = mdr::make_layer_model(c, 20);
    LoadStep s = step(0, 0);
    s.normal.value = 100;
    EXPECT_NE(message([&] { model->advance(s); }).find("the contact reaches the rim"),
              std::string::npos);
}

TEST(MdrLayerModel, SurfaceAndRecordTellTheSame) {
    const auto model = mdr::make_layer_model(layer_case(), 40);
    model->advance(step(0, 0));
    const auto r = model->advance(step(.4e-3, 7));
    const contact::Surface s = model->surface();
    EXPECT_EQ(s.layout, contact::Surface::Layout::line);
    double normal = 0, tangential = 0, normal_3d = 0;
    int n_contact = 0, n_slip = 0;
    for (int i = 0; i < s.n_x; ++i) {
        normal += s.normal_line_load[i] * s.spacing[0];
        tangential += s.tangential_line_load[i] * s.spacing[0];
        normal_3d +=
            s.normal_traction[i] * std::numbers::pi * std::abs(s.x(i) - s.offset[0]) * s.spacing[0];
        n_contact += s.contact_state[i] != contact::ContactState::open;
        n_slip += s.contact_state[i] == contact::ContactState::slip;
        EXPECT_EQ(s.normal_line_load[i] > 0, s.contact_state[i] != contact::ContactState::open);
        EXPECT_LE(std::abs(s.tangential_line_load[i]), .57 * s.normal_line_load[i] * (1 + 1e-12));
        EXPECT_NEAR(s.gap[i] * s.normal_line_load[i], 0, 1e-9 * r.indentation * 1e4);
    }
    EXPECT_NEAR(normal / r.normal_force, 1, 1e-12);
    EXPECT_NEAR(tangential / 7, 1, 1e-9);
    EXPECT_NEAR(normal_3d / r.normal_force, 1, 2e-3);  // midpoint sum over a root at the rim
    const double disc = std::numbers::pi / 4 * s.spacing[0] * s.spacing[0];
    EXPECT_NEAR(r.contact_area / (disc * n_contact * n_contact), 1, 1e-12);
    EXPECT_NEAR((r.contact_area - r.slip_area) / disc, std::pow(n_contact - n_slip, 2), 1e-8);
    EXPECT_GT(n_slip, 0);
    EXPECT_TRUE(model->audit().passed());
}

TEST(MdrLayerModel, AngleOfRollingIsOfNoConsequence) {
    Case along = layer_case(), across = layer_case();
    across.rolling->angle = std::numbers::pi / 2;
    const auto a = contact::run(along, *mdr::make_layer_model(along, 25));
    const auto b = contact::run(across, *mdr::make_layer_model(across, 25));
    ASSERT_EQ(a.steps.size(), b.steps.size());
    for (std::size_t k = 0; k < a.steps.size(); ++k)
        EXPECT_NEAR(a.steps[k].shift[0] / a.static_shift, b.steps[k].shift[0] / a.static_shift,
                    1e-8);  // tolerance of the tangential solver
    EXPECT_GT(b.steps[4].offset[1], 0);
}

// The least bounds since start_limit() are part of the state.
TEST(MdrLayerModel, LeastBoundsOfOtherLawsGoOnFromItsBytes) {
    Case c = layer_case();
    c.friction = {.shear_strength = 1e5};
    const auto model = mdr::make_layer_model(c, 25), other = mdr::make_layer_model(c, 25);
    model->advance(step(0, 0));
    model->start_limit();
    EXPECT_EQ(model->limit_tangential_ratio(), 1);
    model->advance(step(.8e-3, 1));
    other->read_state(model->write_state());
    for (const auto* one : {&model, &other}) (*one)->advance(step(-.8e-3, 1));
    EXPECT_EQ(model->limit_tangential_ratio(), other->limit_tangential_ratio());
    EXPECT_LT(model->limit_tangential_ratio(), .95);
}

TEST(MdrLayerModel, GoesOnFromItsBytes) {
    const auto model = mdr::make_layer_model(layer_case(), 25),
               other = mdr::make_layer_model(layer_case(), 25);
    model->advance(step(0, 0));
    model->advance(step(0, 6));
    other->read_state(model->write_state());
    const auto a = model->advance(step(.5e-3, 6)), b = other->advance(step(.5e-3, 6));
    EXPECT_EQ(a.shift[0], b.shift[0]);
    EXPECT_EQ(a.indentation, b.indentation);
    model->release();
    EXPECT_EQ(model->advance(step(0, 0)).shift[0], 0);
}

// A traction makes an element slip by 5 to 40 times what it moves the contact by: zones of stick
// and slip are told by that, or steps lead nowhere and gradients take over (5 times the products).
TEST(MdrLayerModel, SpringsOfTheInterfaceTakeHardlyMoreProducts) {
    Case c = layer_case();
    const auto products = [&c] {
        int sum = 0;
        for (const auto& s : contact::run(c, *mdr::make_layer_model(c, 100)).steps)
            sum += s.tangential_iterations;
        return sum;
    };
    const int rigid = products();
    for (const double k : {2e9, 5e9, 2e10}) {
        c.interface = {.normal_stiffness = k, .tangential_stiffness = k};
        EXPECT_LT(products(), 1.6 * rigid) << k;
    }
}

TEST(MdrLayerModel, HeldIndentationRelaxesLikeTheModulus) {
    Case c = layer_case();
    c.load.normal_force.reset();
    c.load.indentation = .3e-3;
    const auto elastic = mdr::make_layer_model(c, 25);
    c.relaxation = contact::Relaxation{{{.8, 2.}}, {}};
    const auto model = mdr::make_layer_model(c, 25);
    LoadStep s;
    s.normal = {NormalControl::Kind::indentation, .3e-3};
    const double relaxed = elastic->advance(s).normal_force;
    EXPECT_NEAR(model->advance(s).normal_force / relaxed, 1.8, 1e-9);
    s.duration = 3;
    EXPECT_NEAR(model->advance(s).normal_force / relaxed, 1 + .8 * std::exp(-1.5), 1e-9);
    EXPECT_TRUE(model->audit().passed());
}

}  // namespace
}  // namespace tricontact::layer_model_test
