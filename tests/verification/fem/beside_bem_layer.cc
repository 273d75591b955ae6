// The layer with a mesh and without one: two independent roads to the same contact.

#include <gtest/gtest.h>

#include <array>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "tests/verification/fem/rig.h"

namespace tricontact::fem::fem_beside_bem_layer_test {
namespace {

using contact::Case;
using contact::History;

struct Point {
    double b, w, f;
};
/// A thickness, an amplitude, elements as small as the tolerances ask for, and loads that have one
/// layer in common.
struct Rolling {
    double b, w, size;
    std::array<double, 3> loads;
};
class FemBesideBemLayer : public testing::TestWithParam<Rolling> {};

/// Rolling in few steps, both models in the same ones, by amplitudes over the exact contact radius.
Case rolling_case(const Point& at, double size) {
    Case c = layer_case(size);
    c.layer.thickness = at.b;
    c.load.tangential_force.reset();
    c.load.tangential_ratio = at.f;
    c.load.press_steps = 5;
    c.rolling.emplace();
    c.rolling->amplitude = at.w * exact_contact(c).contact_radius;
    c.rolling->steps_per_quarter = 1;
    c.rolling->periods = 6;
    c.rolling->run_all = true;
    c.of<contact::Cells>().spacing = 2e-4;
    return c;
}

void expect_agreement(const Point& at, double size) {
    SCOPED_TRACE(at.f);
    const Case c = rolling_case(at, size);
    const History fem = contact::run(c, *make_layer_model(c));
    const History bem = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_NEAR(fem.scales.indentation / bem.scales.indentation, 1, .003);
    EXPECT_NEAR(fem.limit_tangential_ratio / bem.limit_tangential_ratio, 1, .01);
    // Sticking tractions are singular at the edge, small f is worst: .9 % at .05.
    EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, .01);
    const auto &u = fem.shift_per_period, &v = bem.shift_per_period;
    EXPECT_NEAR(u.back() / v.back(), 1, .01);
    // In the last period. Where it ratchets most points slip: .7 % of .56 U_max. Else only those at
    // the edge that come into contact do, at other places on nodes than on cells: .003 U_max.
    const double unit = bem.scales.unit_shift, a = bem.scales.contact_radius;
    EXPECT_NEAR(fem.slip_path_per_period.back() / unit, bem.slip_path_per_period.back() / unit,
                5e-3);
    const double density = bem.friction_limit * unit / (a * a);  // at most .5 %, of .23
    EXPECT_NEAR(fem.friction_work_per_period.back() / density,
                bem.friction_work_per_period.back() / density, 2e-3);
    // What it grows by where it ratchets for good.
    if (at.f > 1.2 * bem.limit_tangential_ratio) {
        EXPECT_NEAR((u[5] - u[4]) / (v[5] - v[4]), 1, .03);
    }
}

TEST_P(FemBesideBemLayer, Agree) {
    const auto& [b, w, size, loads] = GetParam();
    for (const double f : loads) expect_agreement({b, w, f}, size);
}
// Both thicknesses and all amplitudes, not all pairs: a layer of 0.5 mm takes 8 s to condense.
INSTANTIATE_TEST_SUITE_P(Rig, FemBesideBemLayer,
                         testing::Values(Rolling{8e-3, .24, 7e-4, {.24, .56, .8}},
                                         Rolling{8e-3, .75, 5e-4, {.05, .3, .5}},
                                         Rolling{4e-3, .51, 5e-4, {.15, .24, .72}}));

// A relaxing layer, incompressible: one function of time for all its stiffness, in both.
TEST(FemBesideBemLayer, RelaxingLayersAgree) {
    Case c = rolling_case({8e-3, .24, .4}, 7e-4);
    c.rolling->periods = 3;
    c.rolling->steps_per_quarter = 3;
    c.rolling->speed = 1e-3;
    c.load.hold = 2;
    c.relaxation = contact::Relaxation{{{.8, .5}, {.3, 5}}, {}};
    const History fem = contact::run(c, *make_layer_model(c));
    const History bem = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, .005);
    for (std::size_t n = 0; n < 3; ++n)
        EXPECT_NEAR(fem.shift_per_period[n] / bem.shift_per_period[n], 1, .01);
    double of_fem = 0, of_bem = 0, friction = 0;
    for (std::size_t k = 0; k < fem.steps.size(); ++k) {
        of_fem += fem.steps[k].material_dissipation;
        of_bem += bem.steps[k].material_dissipation;
        friction += bem.steps[k].dissipation;
    }
    EXPECT_NEAR(of_fem / of_bem, 1, .01);
    EXPECT_GT(of_bem, friction);  // it does matter here
    // And it is another answer than the elastic one.
    c.relaxation.reset();
    const History elastic = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_GT(std::abs(bem.shift_per_period[2] / elastic.shift_per_period[2] - 1), .01);
}

// What the contact says from its surface, and what the body says inside: energy and displacement of
// a layer that has not yet relaxed.
TEST(FemBesideBemLayer, InsideOfARelaxingLayer) {
    Case c = rolling_case({8e-3, .24, .4}, 2e-3);
    c.relaxation = contact::Relaxation{{{.8, .5}, {.3, 5}}, {}};
    c.load.press_time = .4;
    c.load.hold = .2;
    const auto model = make_layer_model(c);
    const auto path = contact::make_load_path(c, *c.load.normal_force, 5e-3);
    contact::StepRecord last;
    for (const auto* steps : {&path.pressing, &path.loading})
        for (const auto& step : *steps) last = model->advance(step);
    const auto inside = model->interior();
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->strain_energy / last.stored_energy, 1, 1e-6);
    const contact::Surface surface = model->surface();
    double deepest = 0, lowest = 0;
    for (const double u : surface.displacement_z) deepest = std::max(deepest, u);
    for (const auto& u : inside->displacement) lowest = std::min(lowest, u[2]);
    EXPECT_NEAR(-lowest / deepest, 1, 1e-6);
    // The relaxed layer under these tractions would be displaced otherwise.
    EXPECT_GT(last.normal_force * last.indentation, 2.2 * last.stored_energy);
}

// Shear relaxes and bulk does not: no common factor, and Poisson's ratio moves.
TEST(FemBesideBemLayer, LayersWhoseShearRelaxesAloneAgree) {
    Case c = rolling_case({8e-3, .24, .4}, 1e-3);
    c.substrate.poisson = .35;
    c.rolling->periods = 2;
    c.rolling->steps_per_quarter = 2;
    c.rolling->speed = 1e-3;
    c.load.hold = 2;
    c.relaxation = contact::Relaxation{{{.8, .5}, {.3, 5}}, contact::Relaxation::Bulk::elastic};
    const History fem = contact::run(c, *make_layer_model(c));
    const History bem = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    // 1 mm elements: 1.5 % in shifts for elastic layers as well.
    EXPECT_NEAR(fem.scales.indentation / bem.scales.indentation, 1, .005);
    EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, .015);
    for (std::size_t n = 0; n < 2; ++n)
        EXPECT_NEAR(fem.shift_per_period[n] / bem.shift_per_period[n], 1, .02);
    double of_fem = 0, of_bem = 0;
    for (std::size_t k = 0; k < fem.steps.size(); ++k) {
        of_fem += fem.steps[k].material_dissipation;
        of_bem += bem.steps[k].material_dissipation;
    }
    EXPECT_NEAR(of_fem / of_bem, 1, .02);
    // And it is another answer than that of a bulk that relaxes alike.
    c.relaxation->bulk = contact::Relaxation::Bulk::proportional;
    const History alike = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    double of_alike = 0;
    for (const auto& step : alike.steps) of_alike += step.material_dissipation;
    EXPECT_GT(std::abs(of_bem / of_alike - 1), .05);
}

}  // namespace
}  // namespace tricontact::fem::fem_beside_bem_layer_test
