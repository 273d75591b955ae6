// The layer with a mesh and without one: two independent roads to the same contact.

#include <gtest/gtest.h>

#include "bem/model.h"
#include "contact/run.h"
#include "tests/verification/fem_rig.h"

namespace tricontact::fem {
namespace {

using contact::Case;
using contact::History;

struct Point {
    double b, w, f;
};
class FemBesideBemLayer : public testing::TestWithParam<Point> {};

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
    c.bem.spacing = 2e-4;
    return c;
}

TEST_P(FemBesideBemLayer, Agree) {
    const Case c = rolling_case(GetParam(), 5e-4);
    const History fem = contact::run(c, *make_layer_model(c));
    const History bem = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    EXPECT_NEAR(fem.scales.indentation / bem.scales.indentation, 1, .003);
    EXPECT_NEAR(fem.limit_tangential_ratio / bem.limit_tangential_ratio, 1, .01);
    // Sticking tractions are singular at the edge: 0.5 mm elements are 1 % too stiff there.
    EXPECT_NEAR(fem.static_shift / bem.static_shift, 1, .012);
    const auto &u = fem.shift_per_period, &v = bem.shift_per_period;
    EXPECT_NEAR(u.back() / v.back(), 1, .012);
    // What it grows by where it ratchets for good.
    if (GetParam().f > 1.2 * bem.limit_tangential_ratio) {
        EXPECT_NEAR((u[5] - u[4]) / (v[5] - v[4]), 1, .03);
    }
}
INSTANTIATE_TEST_SUITE_P(
    Rig, FemBesideBemLayer,
    testing::Values(Point{8e-3, .24, .24}, Point{8e-3, .24, .56}, Point{8e-3, .24, .8},
                    Point{8e-3, .51, .15}, Point{8e-3, .51, .24}, Point{8e-3, .51, .72},
                    Point{8e-3, .75, .05}, Point{8e-3, .75, .3}, Point{8e-3, .75, .5},
                    Point{4e-3, .24, .24}, Point{4e-3, .24, .56}, Point{4e-3, .24, .8},
                    Point{4e-3, .51, .15}, Point{4e-3, .51, .24}, Point{4e-3, .51, .72},
                    Point{4e-3, .75, .05}, Point{4e-3, .75, .3}, Point{4e-3, .75, .5}));

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

}  // namespace
}  // namespace tricontact::fem
